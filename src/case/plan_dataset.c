// Data sets: distributions of machines and conditions, labels with their faults, and sensors.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "plan.h"
#include "plan_batches.h"
#include "plan_course.h"
#include "plan_dataset.h"
#include "plan_names.h"
#include "plan_parts.h"
#include "plan_tolerances.h"
#include "problem.h"
#include "schema.h"
#include "tree.h"
#include "two_pi.h"

// ---------------------------------------------------------------- reading

/// Returns the number of entries of a mapping or list; 0 after a problem. `what`: "1 to 32 labels, {healthy: }".
static size_t entries(case_reader *reader, const file_node *where, int kind, size_t most, const char *what) {
    char shown[SHOWN_SIZE];
    if ((int)where->kind == kind && where->count > 0 && where->count <= most) return where->count;
    problem_at(reader->problems, where, "is %s, expected %s",
               (int)where->kind != kind ? node_shown(where, shown)
               : where->count           ? "a longer list"
                                        : "empty",
               what);
    return 0;
}

/// Takes zeroed memory of the arena; NULL is noted in the reader.
static void *take_zeroed(case_reader *reader, size_t bytes) {
    void *memory = arena_take(reader->arena, bytes);
    reader->no_memory = reader->no_memory || !memory;
    return memory ? memset(memory, 0, bytes) : NULL;
}

/// Reads the distributions of a key's parameters.
static void read_distributions(case_reader *reader, const setting_list *keys, const char *key, distribution_list *out) {
    const setting *given = settings_find(keys, key);
    if (!given || node_is_null(given->place)) return;
    const size_t count = entries(reader, given->place, NODE_MAPPING, WHIRL_MAX_DRAWN,
                                 "1 to 32 parameters with their tolerances, {c: 0.2 mm +- 5 %}");
    out->items = count > 0 ? take_zeroed(reader, count * sizeof *out->items) : NULL;
    for (const file_node *one = out->items ? given->place->first : NULL; one; one = one->next)
        out->count += distribution_read(reader, one, &out->items[out->count]);
}

static void read_graded(case_reader *reader, const file_node *where, graded_parts *out) {
    static const char *const names[] = {"from", "to"};
    number_formula *const values[] = {&out->from, &out->to};
    out->place = where;
    out->keys = (setting_list){.name = schema_grade.name, .group = &schema_grade, .place = where};
    out->parameter = plan_find_named(reader, where);
    settings_read(reader, where, &schema_grade, &out->keys);
    if (!out->parameter || !plan_check_free(reader, where, out->parameter)) return;
    const whirl_key key = {
        .name = out->parameter->name, .unit = parameter_expected_unit(out->parameter), .range = WHIRL_ANY};
    for (size_t i = 0; i < 2; i++) {
        const setting *given = settings_find(&out->keys, names[i]);
        if (given) formula_read(reader, given->place, &key, values[i]);
    }
}

static void read_label(case_reader *reader, const file_node *where, label_parts *out) {
    out->place = where;
    out->keys = (setting_list){.name = schema_label.name, .group = &schema_label, .place = where};
    settings_read(reader, where, &schema_label, &out->keys);
    if (strlen(where->key) >= WHIRL_NAME_SIZE || strpbrk(where->key, ":,\"\r\n"))
        problem_at_key(reader->problems, where,
                       "is no name for a label, expected up to %d letters without : , and quotes", WHIRL_NAME_SIZE - 1);
    read_distributions(reader, &out->keys, "vary", &out->varied);
    const setting *grade = settings_find(&out->keys, "grade");
    if (!grade) return;
    const size_t count = entries(reader, grade->place, NODE_MAPPING, WHIRL_MAX_DRAWN,
                                 "1 to 32 parameters that the severity sets, {gap: {from: 90 um, to: 30 um}}");
    out->graded = count > 0 ? take_zeroed(reader, count * sizeof *out->graded) : NULL;
    for (const file_node *one = out->graded ? grade->place->first : NULL; one; one = one->next)
        read_graded(reader, one, &out->graded[out->graded_count++]);
}

/// Reads the station of a channel.
static void read_station(case_reader *reader, const machine_parts *machine, channel_parts *out) {
    char advice[WHY_SIZE], shown[SHOWN_SIZE];
    const setting *at = settings_find(&out->keys, "at");
    const bool pulses = out->sensor == WHIRL_SENSOR_KEYPHASOR;
    if (pulses && at)
        problem_at_key(reader->problems, at->place, "has no meaning for a keyphasor, which sees the shaft");
    if (!pulses && !at)
        problem_missing(reader->problems, out->place, "at", "is missing, expected the station of the sensor");
    if (pulses || !at) return;
    const char *name = at->place->kind == NODE_TEXT ? at->place->text : "";
    out->station = named_find(&machine->stations, name);
    if (out->station < machine->stations.count) return;
    machine_advise(machine, name, false, advice);
    problem_at(reader->problems, at->place, "is %s, which is no station, %s", node_shown(at->place, shown), advice);
}

/// Reads the numbers whose unit depends on the sensor.
static void read_channel_numbers(case_reader *reader, channel_parts *out) {
    static const char *const names[CHANNEL_NUMBERS] = {"sensitivity", "from", "to", "noise", "full_scale"};
    const char *measured = whirl_sensor_unit(out->sensor);
    const char *signal = settings_find(&out->keys, "sensitivity") ? "V" : measured;
    const char *const units[CHANNEL_NUMBERS] = {whirl_sensor_sensitivity_unit(out->sensor), measured, measured, signal,
                                                signal};
    static const whirl_range ranges[CHANNEL_NUMBERS] = {WHIRL_ANY, WHIRL_ANY, WHIRL_ANY, WHIRL_NOT_NEGATIVE,
                                                        WHIRL_POSITIVE};
    for (size_t i = 0; i < CHANNEL_NUMBERS; i++) {
        out->given[i] = settings_find(&out->keys, names[i]);
        const whirl_key key = {.name = names[i], .unit = units[i], .range = ranges[i]};
        if (out->given[i]) formula_read(reader, out->given[i]->place, &key, &out->numbers[i]);
    }
}

/// Refuses keys that the sensor does not have.
static void check_channel_keys(case_reader *reader, const channel_parts *own) {
    static const struct {
        const char *key;
        unsigned sensors; ///< a bit for each kind that has it
    } keys[] = {{"angle", 7},   {"gap", 1},       {"from", 7},   {"to", 7},    {"resonance", 4},
                {"damping", 4}, {"high_pass", 7}, {"pulses", 8}, {"width", 8}, {"jitter", 8}};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const setting *given = settings_find(&own->keys, keys[i].key);
        if (given && !(keys[i].sensors >> own->sensor & 1u))
            problem_at_key(reader->problems, given->place, "has no meaning for a sensor: %s",
                           whirl_sensor_name(own->sensor));
    }
    const setting *bits = settings_find(&own->keys, "bits"), *full = settings_find(&own->keys, "full_scale");
    if (!bits != !full)
        problem_missing(reader->problems, own->place, bits ? "full_scale" : "bits",
                        "is missing, expected both bits and full_scale of the converter");
}

static void read_channel(case_reader *reader, const file_node *where, const machine_parts *machine, size_t number,
                         channel_parts *out) {
    out->place = where;
    out->keys = (setting_list){.name = schema_channel.name, .group = &schema_channel, .place = where};
    settings_read(reader, where, &schema_channel, &out->keys);
    const setting *sensor = settings_find(&out->keys, "sensor"), *name = settings_find(&out->keys, "name");
    if (!sensor || !sensor->good) return; // has been reported
    while (strcmp(sensor->word, whirl_sensor_name(out->sensor)) != 0) out->sensor++;
    read_station(reader, machine, out);
    read_channel_numbers(reader, out);
    check_channel_keys(reader, out);
    // Read the name, or make one.
    char text[WHIRL_NAME_SIZE];
    const bool seen = out->sensor != WHIRL_SENSOR_KEYPHASOR && out->station < machine->stations.count;
    if (name)
        settings_text(reader, &out->keys, "name", text, sizeof text);
    else
        snprintf(text, sizeof text, "%s%s%.30s %zu", whirl_sensor_name(out->sensor), seen ? " " : "",
                 seen ? machine->stations.names[out->station] : "", number);
    if (strpbrk(text, ":,"))
        problem_at(reader->problems, name->place, "is no name for a channel, expected one without : and ,");
    out->name = arena_text(reader->arena, text, strlen(text));
    reader->no_memory = reader->no_memory || !out->name;
}

/// Refuses a parameter that two of a data set's own lists draw.
static void check_drawn_once(case_reader *reader, const dataset_parts *own) {
    for (size_t i = 0; i < own->vary.count; i++)
        for (size_t k = 0; k < own->conditions.count; k++)
            if (own->vary.items[i].parameter == own->conditions.items[k].parameter)
                problem_at_key(reader->problems, own->conditions.items[k].place,
                               "differs between machines already (vary), expected another parameter");
    for (size_t l = 0; l < own->label_count; l++)
        for (size_t i = 0; i < own->labels[l].graded_count; i++)
            for (size_t k = 0; k < own->labels[l].varied.count; k++)
                if (own->labels[l].graded[i].parameter == own->labels[l].varied.items[k].parameter)
                    problem_at_key(reader->problems, own->labels[l].varied.items[k].place,
                                   "is graded already, expected another parameter");
}

/// Reads the run of the records. Its course exists even without a table of speeds, which each record then makes.
static void read_run(case_reader *reader, const machine_parts *machine, dataset_parts *own) {
    static const char *const known[] = {"speed_from", "speed_to", "rate",   "speeds", "begin", "settle",
                                        "samples",    "rtol",     "method", "rows",   "events"};
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(&own->keys, "runup");
    if (!given) return;
    const whirl_group *group = &schema_at_rest[SCHEMA_AT_REST_runup];
    setting_list *keys = take_zeroed(reader, sizeof *keys);
    course_parts *course = take_zeroed(reader, sizeof *course);
    if (!keys || !course) return;
    *keys = (setting_list){.name = group->name, .group = group, .place = given->place};
    settings_read(reader, given->place, group, keys);
    for (size_t i = 0; i < keys->count; i++) {
        const setting *one = &keys->items[i];
        size_t k = 0;
        while (k < sizeof known / sizeof *known && strcmp(known[k], one->key->name) != 0) k++;
        if (k == sizeof known / sizeof *known)
            problem_at_key(reader->problems, one->place,
                           "has no meaning for records, expected speed_from, speed_to and rate, or speeds, with begin, "
                           "settle, samples, rtol, method, rows and events");
    }
    const bool table = settings_find(keys, "speeds"), from = settings_find(keys, "speed_from");
    const bool to = settings_find(keys, "speed_to"), rate = settings_find(keys, "rate");
    if (table ? from || to || rate : !to || !rate)
        problem_at(reader->problems, given->place, "is %s, expected speed_from, speed_to and rate, or speeds",
                   table ? "speeds and a rate" : node_shown(given->place, shown));
    const course_parts *read = course_read(reader, machine, keys);
    // The speed of records follows a law, and all records have the same number of samples.
    for (size_t i = 0; read && i < read->event_count; i++) {
        const course_event *event = &read->events[i];
        if (event->trip)
            problem_at_key(
                reader->problems, event->place,
                "is the trip of a motor, and the speed of records follows a law, expected loss_at or change");
        if (event->end)
            problem_at_key(reader->problems, event->place,
                           "ends the run, and records need all their samples, expected loss_at or change");
    }
    own->runup = keys;
    own->course = read ? read : course;
}

void dataset_read(case_reader *reader, const machine_parts *machine, plan_parts *parts) {
    dataset_parts *own = &parts->dataset;
    const setting *given = settings_find(&parts->study, schema_dataset.name);
    if (!given) return;
    own->machine = machine;
    own->keys = (setting_list){.name = schema_dataset.name, .group = &schema_dataset, .place = given->place};
    settings_read(reader, given->place, &schema_dataset, &own->keys);
    read_distributions(reader, &own->keys, "vary", &own->vary);
    read_distributions(reader, &own->keys, "conditions", &own->conditions);
    // Read the labels.
    const setting *labels = settings_find(&own->keys, "labels"), *channels = settings_find(&own->keys, "channels");
    size_t count = labels ? entries(reader, labels->place, NODE_MAPPING, WHIRL_MAX_LABELS,
                                    "1 to 32 labels with their faults, {healthy: , rub: {grade: ...}}")
                          : 0;
    own->labels = count > 0 ? take_zeroed(reader, count * sizeof *own->labels) : NULL;
    for (const file_node *one = own->labels ? labels->place->first : NULL; one; one = one->next)
        read_label(reader, one, &own->labels[own->label_count++]);
    // Read the channels.
    count = channels ? entries(reader, channels->place, NODE_LIST, WHIRL_MAX_CHANNELS,
                               "a list of 1 to 32 sensors, [{sensor: proximity, at: disc}]")
                     : 0;
    own->channels = count > 0 ? take_zeroed(reader, count * sizeof *own->channels) : NULL;
    for (const file_node *one = own->channels ? channels->place->first : NULL; one; one = one->next) {
        read_channel(reader, one, machine, own->channel_count + 1, &own->channels[own->channel_count]);
        own->channel_count++;
    }
    read_run(reader, machine, own);
    check_drawn_once(reader, own);
}

// ---------------------------------------------------------------- what differs between records

/// A data set that is being made.
typedef struct dataset_maker {
    case_reader *reader;
    valuation *v;
    whirl_dataset *made;
    const char **names; ///< [WHIRL_MAX_DRAWN] names of parameters
    double *values;     ///< [WHIRL_MAX_DRAWN] their values in the case, SI
    bool good;
} dataset_maker;

/// Returns the index of a parameter among those that differ; it is added if it is new.
static size_t drawn_index(dataset_maker *m, const parameter *own, const file_node *where) {
    size_t index = 0;
    while (index < m->made->parameter_count && strcmp(m->names[index], own->name) != 0) index++;
    if (index < m->made->parameter_count) return index;
    if (index == WHIRL_MAX_DRAWN) {
        problem_at_key(m->reader->problems, where, "is one parameter too many, expected at most %d that differ",
                       WHIRL_MAX_DRAWN);
        m->good = false;
        return 0;
    }
    m->names[index] = own->name;
    m->values[index] = m->v->values[own - m->v->parameters->items];
    m->made->parameter_count++;
    return index;
}

static const whirl_drawn *make_drawn(dataset_maker *m, const distribution_list *list) {
    whirl_drawn *drawn = take_zeroed(m->reader, (list->count + 1) * sizeof *drawn);
    for (size_t i = 0; drawn && i < list->count; i++) {
        drawn[i].parameter = drawn_index(m, list->items[i].parameter, list->items[i].place);
        m->good = distribution_make(m->reader, m->v, &list->items[i], &drawn[i].of) && m->good;
    }
    m->good = m->good && drawn;
    return drawn;
}

static void make_label(dataset_maker *m, const label_parts *parts, whirl_label *label) {
    whirl_graded *graded = take_zeroed(m->reader, (parts->graded_count + 1) * sizeof *graded);
    m->good = m->good && graded;
    for (size_t i = 0; graded && i < parts->graded_count; i++) {
        const graded_parts *own = &parts->graded[i];
        graded[i].parameter = drawn_index(m, own->parameter, own->place);
        m->good = plan_formula_value(m->reader, m->v, own->place, &own->from, &graded[i].from) && m->good;
        m->good = plan_formula_value(m->reader, m->v, own->place, &own->to, &graded[i].to) && m->good;
    }
    *label = (whirl_label){.name = parts->place->key,
                           .graded_count = parts->graded_count,
                           .graded = graded,
                           .varied_count = parts->varied.count};
    label->varied = make_drawn(m, &parts->varied);
}

static void make_channel(dataset_maker *m, const channel_parts *parts, whirl_channel *channel) {
    const setting_list *keys = &parts->keys;
    double numbers[CHANNEL_NUMBERS] = {1.0, -INFINITY, INFINITY, 0.0, 0.0};
    if (!settings_check(m->reader, m->v, keys)) {
        m->good = false;
        return;
    }
    for (size_t i = 0; i < CHANNEL_NUMBERS; i++)
        if (parts->given[i])
            m->good =
                plan_formula_value(m->reader, m->v, parts->given[i]->place, &parts->numbers[i], &numbers[i]) && m->good;
    const bool gap = settings_find(keys, "gap"), high_pass = settings_find(keys, "high_pass");
    const bool resonance = settings_find(keys, "resonance"), bits = settings_find(keys, "bits");
    *channel = (whirl_channel){.name = parts->name,
                               .sensor = parts->sensor,
                               .station = parts->station,
                               .angle = settings_number(m->v, keys, "angle"),
                               .gap = gap ? settings_number(m->v, keys, "gap") : 0.0,
                               .low = numbers[CHANNEL_FROM],
                               .high = numbers[CHANNEL_TO],
                               .resonance = resonance ? settings_number(m->v, keys, "resonance") : 0.0,
                               .damping = settings_number(m->v, keys, "damping"),
                               .high_pass = high_pass ? settings_number(m->v, keys, "high_pass") : 0.0,
                               .pulses = (int)settings_number(m->v, keys, "pulses"),
                               .width = settings_number(m->v, keys, "width"),
                               .jitter = settings_number(m->v, keys, "jitter"),
                               .in_volts = parts->given[CHANNEL_SENSITIVITY] != NULL,
                               .sensitivity = numbers[CHANNEL_SENSITIVITY],
                               .noise = numbers[CHANNEL_NOISE],
                               .full_scale = numbers[CHANNEL_FULL_SCALE],
                               .bits = bits ? (int)settings_number(m->v, keys, "bits") : 0};
    if (channel->low < channel->high) return;
    problem_at(m->reader->problems, parts->given[CHANNEL_TO] ? parts->given[CHANNEL_TO]->place : parts->place,
               "gives a range from %.6g to %.6g %s, expected its lower end first", channel->low, channel->high,
               whirl_sensor_unit(parts->sensor));
    m->good = false;
}

/// Makes the data set; NULL after a problem.
static const whirl_dataset *make_dataset(case_reader *reader, valuation *v, const dataset_parts *parts) {
    whirl_dataset *made = take_zeroed(reader, sizeof *made);
    dataset_maker m = {.reader = reader, .v = v, .made = made, .good = true};
    m.names = take_zeroed(reader, WHIRL_MAX_DRAWN * sizeof *m.names);
    m.values = take_zeroed(reader, WHIRL_MAX_DRAWN * sizeof *m.values);
    whirl_label *labels = take_zeroed(reader, (parts->label_count + 1) * sizeof *labels);
    whirl_channel *channels = take_zeroed(reader, (parts->channel_count + 1) * sizeof *channels);
    if (reader->no_memory) return NULL;
    made->machine_count = parts->vary.count;
    made->machine = make_drawn(&m, &parts->vary);
    made->condition_count = parts->conditions.count;
    made->conditions = make_drawn(&m, &parts->conditions);
    for (size_t i = 0; i < parts->label_count; i++) make_label(&m, &parts->labels[i], &labels[i]);
    for (size_t i = 0; i < parts->channel_count; i++) make_channel(&m, &parts->channels[i], &channels[i]);
    made->labels = labels;
    made->label_count = parts->label_count;
    made->channels = channels;
    made->channel_count = parts->channel_count;
    made->parameters = m.names;
    made->values = m.values;
    return m.good && !reader->no_memory ? made : NULL;
}

// ---------------------------------------------------------------- the batch

/// Refuses contradictory ways to sample; sets the samples of a record at equal angles.
static bool check_sampling(case_reader *reader, const dataset_parts *own, whirl_dataset_options *options) {
    const file_node *place = own->keys.place;
    const bool angles = settings_find(&own->keys, "samples_per_revolution") && options->per_revolution > 0.0;
    const bool turns = settings_find(&own->keys, "revolutions") && options->turns > 0.0;
    const bool rate = settings_find(&own->keys, "rate") && options->rate > 0.0, samples = options->samples > 0;
    if (angles != turns || rate != samples || angles == rate) {
        problem_at(reader->problems, place,
                   "has %s, expected samples_per_revolution and revolutions, or rate and samples",
                   angles || turns   ? rate || samples ? "keys of both ways to sample" : "half of a way to sample"
                   : rate || samples ? "half of a way to sample"
                                     : "no rate of samples");
        return false;
    }
    const double count = angles ? round(options->turns * options->per_revolution) : options->samples;
    if (count < 2.0 || count > WHIRL_MAX_RECORD_SAMPLES || fmod(count, 2.0) != 0.0) {
        problem_at(reader->problems, place, "has records of %.10g samples, expected an even number up to %d", count,
                   WHIRL_MAX_RECORD_SAMPLES);
        return false;
    }
    options->samples = (int)count;
    return true;
}

// ---------------------------------------------------------------- the motions behind the samples

/// Finds the slowest and the fastest speed of the records, rad/s. If there are more than MAX_TRIED, it tries every n-th
/// of them, and adds a margin.
static whirl_status find_speeds(valuation *v, const dataset_parts *own, const whirl_batch *batch, double speeds[2]) {
    enum { MAX_TRIED = 20000 };
    const setting *speed = settings_find(&own->machine->rotor, "speed");
    whirl_batch all = *batch; // a record that is made alone is as long as the others
    all.record.dataset.only = 0;
    all.count = whirl_dataset_records(&all.record.dataset);
    const size_t step = 1 + all.count / MAX_TRIED;
    whirl_given given[PLAN_MAX_GIVEN];
    whirl_status status = whirl_ok();
    speeds[0] = INFINITY;
    speeds[1] = 0.0;
    for (size_t i = 0; i < all.count && status.code == WHIRL_OK; i += step) {
        double value = 0.0;
        valuation one;
        status = valuation_open(&one, v->parameters, given, plan_given_at(&all, i, given));
        if (status.code == WHIRL_OK) status = valuation_number(&one, &speed->value, &value);
        valuation_close(&one);
        speeds[0] = fmin(speeds[0], value);
        speeds[1] = fmax(speeds[1], value);
    }
    if (step > 1) speeds[0] *= 0.98, speeds[1] *= 1.02;
    return status;
}

static void finish_motions(case_reader *reader, valuation *v, const plan_parts *parts, whirl_batch *batch) {
    const dataset_parts *own = &parts->dataset;
    whirl_dataset_options *options = &batch->record.dataset;
    const setting *length = settings_find(&parts->integrate, "record"),
                  *starts = settings_find(&parts->study, "starts");
    const setting *steps = settings_find(&parts->integrate, "steps_per_revolution");
    double speeds[2] = {0.0, 0.0};
    if (length)
        problem_at_key(reader->problems, length->place,
                       "is given together with dataset, which determines the length of records");
    if (starts)
        problem_at_key(reader->problems, starts->place, "is given together with dataset, expected one of the two");
    // Find the largest and the smallest number of samples in a revolution.
    double most = options->per_revolution, least = most;
    if (options->rate > 0.0) {
        const whirl_status status = find_speeds(v, own, batch, speeds);
        if (status.code == WHIRL_OK && !(speeds[0] > 0.0)) return; // reported where the speed is read
        if (status.code != WHIRL_OK) {
            problem_at(reader->problems, own->keys.place, "%s", status.message);
            return;
        }
        most = two_pi * options->rate / speeds[0];
        least = two_pi * options->rate / speeds[1];
    }
    // Make the record long enough: for the samples, on both sides for the reach of the filters and a revolution to
    // settle, and for the angle at the first sample.
    const double turns = options->rate > 0.0 ? options->samples / least : options->turns;
    options->lead = ceil(WHIRL_SENSOR_REACH / least) + 1.0;
    batch->record.record = (int)ceil(turns + 2.0 * options->lead + 1.0);
    const int instants = (int)ceil(WHIRL_SENSOR_INSTANTS * most - 1e-9);
    if (turns > WHIRL_MAX_RECORD / 2 || most > WHIRL_MAX_STEPS / WHIRL_SENSOR_INSTANTS) {
        problem_at(reader->problems, own->keys.place, "has records of %.6g revolutions of %.6g samples, expected fewer",
                   turns, most);
        return;
    }
    // Set the instants of the motion; they are the steps of a method of fixed steps.
    const bool adaptive = whirl_method_is_adaptive(batch->integrate.method);
    if (!steps && (adaptive || strcmp(batch->integrate.method, "auto") == 0))
        batch->integrate.steps_per_revolution = instants;
    if (batch->integrate.steps_per_revolution < instants)
        problem_at(reader->problems, steps ? steps->place : own->keys.place,
                   "gives %d steps of a revolution, expected at least %d for %.6g samples of one",
                   batch->integrate.steps_per_revolution, instants, most);
    batch->record.samples_per_revolution = instants;
    batch->record.waveform = true;
    batch->record.waveform_revolutions = 0;
    batch->record.spectra = false;
}

/// Completes the batch of records of runs, whose motions are those of a study `runup`.
static void finish_runs(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result,
                        whirl_batch *batch) {
    const dataset_parts *own = &parts->dataset;
    const setting *const without[] = {settings_find(&parts->study, "integrate"),
                                      settings_find(&parts->study, "analyze"), settings_find(&parts->study, "starts")};
    whirl_analysis_set runs = 0;
    // Refuse what belongs to motions at a constant speed.
    for (size_t i = 0; i < sizeof without / sizeof *without; i++)
        if (without[i])
            problem_at_key(reader->problems, without[i]->place,
                           "has no meaning for records of runs, expected settle, samples, rtol and method in runup");
    if (!(batch->record.dataset.rate > 0.0))
        problem_at(reader->problems, own->keys.place,
                   "has samples at equal angles and a runup, expected rate and samples");
    if (!settings_check(reader, v, own->runup) || !course_check(reader, v, own->course)) return;
    // Take the options of the run at the case's own values; those of each record follow in dataset_run.
    const whirl_dataset_options dataset = batch->record.dataset;
    whirl_analysis_add(&runs, "runup");
    batch->integrate = whirl_integrate_default();
    batch->record = whirl_record_default();
    if (batch->record.samples_per_revolution > batch->integrate.steps_per_revolution)
        batch->record.samples_per_revolution = batch->integrate.steps_per_revolution;
    settings_take(v, own->runup, whirl_record_members(), &batch->record);
    settings_take(v, own->runup, whirl_runup_members(), &batch->record.runup);
    batch->record.dataset = dataset;
    snprintf(batch->record.runup.sensitivity, sizeof batch->record.runup.sensitivity, "no");
    if (!settings_find(own->runup, "rows")) batch->record.runup.rows = 2;
    batch->record.runup.event_count = (int)own->course->event_count;
    plan_choose_analyses(batch, runs, false);
    const size_t index = plan_batch(result, batch->name);
    result->origins[index].course = own->course;
    result->origins[index].runup = own->runup;
}

whirl_status dataset_run(const setting_list *keys, const whirl_batch *batch, valuation *v, course_run *course,
                         whirl_runup_options *options) {
    // Find the speeds of this record, as a table that begins at its first sample.
    const whirl_run_course *shown = course_shown(course);
    *options = batch->record.runup;
    settings_take(v, keys, whirl_runup_members(), options);
    snprintf(options->sensitivity, sizeof options->sensitivity, "no");
    options->rows = batch->record.runup.rows;
    options->event_count = batch->record.runup.event_count;
    if (shown->speed_count == 0) {
        const double from = options->from, to = options->to, rate = options->rate;
        if (!(from >= 0.0 && to > 0.0 && rate > 0.0) || from == to)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the run goes from %.6g to %.6g rad/s at %.6g rad/s2, expected two speeds, the last one "
                              "above 0, and a rate above 0",
                              from, to, rate);
        course_set_rate(course, from, to, rate);
    }
    // Let the shaft turn at the first speed before the record, so that it has the angle of the record at the first
    // sample.
    const double first = shown->speeds[0], turn = 6.283185307179586476925;
    const double lead = whirl_dataset_lead(&batch->record.dataset, first);
    const whirl_record_of record =
        whirl_dataset_record(batch->dataset, &batch->record.dataset, batch->sampled > 0 ? batch->sampled - 1 : 0, NULL);
    const double angle = turn * record.begin - first * lead;
    options->angle = angle - turn * floor(angle / turn);
    options->duration = whirl_dataset_duration(&batch->record.dataset, lead);
    options->from = options->to = options->rate = 0.0;
    snprintf(options->speeds, sizeof options->speeds, "of the record");
    if (!settings_find(keys, "begin"))
        snprintf(options->begin, sizeof options->begin, "%s", first > 0.0 ? "steady" : "rest");
    if (strcmp(options->begin, "steady") == 0 && first == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT, "the run begins steady at standstill, expected speeds above 0");
    return course_lead(course, lead);
}

void dataset_make(case_reader *reader, valuation *v, const plan_parts *parts, study_plan *result) {
    const dataset_parts *own = &parts->dataset;
    whirl_dataset_options options = {0};
    if (!own->keys.place || !settings_check(reader, v, &own->keys)) return;
    settings_take(v, &own->keys, whirl_dataset_members(), &options);
    const whirl_dataset *dataset = make_dataset(reader, v, own);
    if (!dataset || !check_sampling(reader, own, &options)) return;
    options.labels = (int)dataset->label_count;
    options.channels = (int)dataset->channel_count;
    options.parameters = (int)dataset->parameter_count;
    // Refuse too many records.
    const double all = (double)options.machines * options.records * options.labels;
    if (all > WHIRL_MAX_RECORDS) {
        problem_at_key(reader->problems, own->keys.place, "has %.10g records, expected at most %d", all,
                       WHIRL_MAX_RECORDS);
        return;
    }
    if (options.only > all) {
        problem_at(reader->problems, settings_find(&own->keys, "only")->place, "is %d, expected at most %.10g records",
                   options.only, all);
        return;
    }
    if (options.train + options.validation > 1.0 + 1e-12) {
        problem_at_key(reader->problems, own->keys.place, "has %.3g %% of its machines for training and validation",
                       100.0 * (options.train + options.validation));
        return;
    }
    result->dataset = dataset;
    whirl_batch *batch = plan_add_batch(result, WHIRL_ROLE_RECORDS, "records", own->keys.place);
    batch->count = whirl_dataset_records(&options);
    plan_options(v, parts, &batch->integrate, &batch->record);
    batch->record.dataset = options;
    batch->dataset = dataset;
    if (own->runup) {
        finish_runs(reader, v, parts, result, batch);
        return;
    }
    plan_finish_points(reader, v, parts, result, batch);
    finish_motions(reader, v, parts, batch);
}
