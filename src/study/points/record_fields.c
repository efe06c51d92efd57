// Fields of the records of a data set: machine, label and condition of each, and its signals.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "added_field.h"
#include "record_fields.h"
#include "whirl/engine/study.h"

/// Numbers of a record, a field each.
static const struct {
    const char *name, *unit, *meaning;
} record_numbers[] = {
    {WHIRL_FIELD_DATASET_RECORD, "1", "number of the record, from 1"},
    {WHIRL_FIELD_DATASET_MACHINE, "1", "number of its machine, from 1"},
    {WHIRL_FIELD_DATASET_LABEL, "1", "index of its label, from 0"},
    {WHIRL_FIELD_DATASET_SEVERITY, "1", "severity of its fault, 0 to 1 (missing where the label has none)"},
    {WHIRL_FIELD_DATASET_SPLIT, "1", "0: for training, 1: for validation, 2: for testing"},
    {WHIRL_FIELD_DATASET_SEED, "1", "seed of its noise and jitter"},
    {WHIRL_FIELD_DATASET_BEGIN, "revolution", "angle of the shaft at the first sample"},
    {WHIRL_FIELD_DATASET_SPEED, "rad/s", "speed of the shaft; in a run at the first sample"},
    {WHIRL_FIELD_DATASET_END_SPEED, "rad/s", "speed of the shaft at the last sample"},
    {WHIRL_FIELD_DATASET_RATE, "1", "rate of the speed at the first sample, rad/s2"},
};
enum { RECORD_NUMBERS = sizeof record_numbers / sizeof *record_numbers, RUN_NUMBERS = 2 };

/// Returns the number of these fields: the last ones are those of runs.
static size_t records_number_count(const whirl_batch *batch) {
    return whirl_analysis_has(batch->analyses, "runup") ? RECORD_NUMBERS : RECORD_NUMBERS - RUN_NUMBERS;
}

whirl_status records_add_fields(const whirl_batch *batch, whirl_layout *layout) {
    const whirl_dataset_options *options = &batch->record.dataset;
    if (!batch->dataset) return whirl_ok();
    if (layout->field_count + RECORD_NUMBERS + 2 > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields",
                          WHIRL_MAX_FIELDS - RECORD_NUMBERS - 2);
    for (size_t i = 0; i < records_number_count(batch); i++)
        study_add_field(layout, record_numbers[i].name, record_numbers[i].unit, record_numbers[i].meaning);
    if (batch->dataset->parameter_count > 0) {
        study_add_field(layout, WHIRL_FIELD_DATASET_VALUES, "1",
                        "values of the parameters that differ between records, in their order, in SI");
        layout->fields[layout->field_count - 1].rows = batch->dataset->parameter_count;
        layout->size += batch->dataset->parameter_count - 1;
    }
    study_add_field(layout, WHIRL_FIELD_DATASET_SIGNALS, "1",
                    "signals of all channels, in single precision, each in the unit of its channel");
    whirl_field *signals = &layout->fields[layout->field_count - 1];
    signals->singles = (size_t)options->samples;
    signals->rows = batch->dataset->channel_count;
    signals->columns = signals->singles / 2;
    layout->size += signals->rows * signals->columns - 1;
    return whirl_ok();
}

/// Fills in the signals of a record; NaN if the motion did not last.
static whirl_status records_sample(const whirl_batch *batch, const whirl_record_of *own, const whirl_machine *machine,
                                   const whirl_record *record, float *signals) {
    const whirl_dataset *dataset = batch->dataset;
    const whirl_dataset_options *options = &batch->record.dataset;
    const double turns_per_second = machine->clock / record->period;
    const whirl_sampling sampling = {.samples = (size_t)options->samples,
                                     .rate = options->per_revolution > 0.0 ? options->per_revolution * turns_per_second
                                                                           : options->rate,
                                     .from = options->lead + own->begin,
                                     .seed = own->seed,
                                     .length = machine->length,
                                     .clock = machine->clock};
    if (record->motion == WHIRL_BOUNDED)
        return whirl_channels_sample(record, dataset->channels, dataset->channel_count, &sampling, signals);
    for (size_t i = 0; i < dataset->channel_count * sampling.samples; i++) signals[i] = NAN;
    return whirl_ok();
}

/// Fills in what is known of a record before its motion: all numbers, and the values of parameters.
static whirl_record_of records_note_numbers(const whirl_batch *batch, size_t point, const double run[3],
                                            const whirl_layout *layout, double *block) {
    const whirl_field *first = whirl_layout_field(layout, record_numbers[0].name);
    const whirl_field *values = whirl_layout_field(layout, WHIRL_FIELD_DATASET_VALUES);
    const whirl_record_of own =
        whirl_dataset_record(batch->dataset, &batch->record.dataset, point, values ? block + values->offset : NULL);
    const double numbers[RECORD_NUMBERS] = {(double)own.number,
                                            (double)own.machine,
                                            (double)own.label,
                                            own.severity,
                                            (double)own.split,
                                            (double)own.seed,
                                            own.begin,
                                            run[0],
                                            run[1],
                                            run[2]};
    memcpy(block + first->offset, numbers, records_number_count(batch) * sizeof *numbers);
    return own;
}

whirl_status records_note(const whirl_batch *batch, size_t point, const whirl_machine *machine,
                          const whirl_record *record, const whirl_layout *layout, double *block) {
    const double speeds[3] = {machine->speed, machine->speed, 0.0};
    const whirl_field *signals = whirl_layout_field(layout, WHIRL_FIELD_DATASET_SIGNALS);
    if (!batch->dataset || !signals) return whirl_ok();
    const whirl_record_of own = records_note_numbers(batch, point, speeds, layout, block);
    return records_sample(batch, &own, machine, record, (float *)(block + signals->offset));
}

// ---------------------------------------------------------------- runs

/// Samples of the motion before the first sample of a run and after its last one.
enum { RUN_MARGIN = WHIRL_SENSOR_REACH + 2 };

/// Returns the time of the first sample of a run, s.
static double records_first_time(const whirl_batch *batch, const whirl_machine *machine) {
    return whirl_dataset_lead(&batch->record.dataset, machine->course->speeds[0]);
}

/// Returns the number of instants of the motion of a run.
static size_t records_instants(const whirl_dataset_options *options) {
    return (size_t)WHIRL_SENSOR_INSTANTS * ((size_t)options->samples - 1 + 2 * (size_t)RUN_MARGIN) + 1;
}

size_t records_run_limit(const whirl_batch *batch, size_t stations, size_t most) {
    enum { BYTES = 1 << 25 };
    if (!batch->dataset) return most;
    const size_t own = records_instants(&batch->record.dataset) * (2 * stations + 1) * sizeof(double);
    const size_t limit = BYTES / own;
    return limit < 1 ? 1 : limit > most ? most : limit;
}

whirl_status records_run_new(const whirl_batch *batch, const whirl_machine *machine, whirl_run_motion *motion) {
    const whirl_dataset_options *options = &batch->record.dataset;
    *motion = (whirl_run_motion){.probes = machine->system->probe_count};
    if (!batch->dataset || !machine->course) return whirl_ok();
    motion->step = 1.0 / (WHIRL_SENSOR_INSTANTS * options->rate);
    motion->from = records_first_time(batch, machine) - RUN_MARGIN / options->rate;
    motion->count = records_instants(options);
    motion->x = calloc(motion->count * (2 * motion->probes + 1), sizeof *motion->x);
    motion->angle = motion->x ? motion->x + 2 * motion->probes * motion->count : NULL;
    return motion->x ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the motion of a record");
}

void records_run_free(whirl_run_motion *motion) {
    free(motion->x);
    motion->x = motion->angle = NULL;
}

/// Returns the speed that the table of a run gives at a time, s, and its rate there.
static double records_speed_at(const whirl_run_course *course, double time, double *rate) {
    const size_t k = whirl_run_row_after(course->speed_count, course->speed_times, time); // a table begins at time 0
    *rate = 0.0;
    if (k == course->speed_count) return course->speeds[k - 1];
    *rate = (course->speeds[k] - course->speeds[k - 1]) / (course->speed_times[k] - course->speed_times[k - 1]);
    return course->speeds[k - 1] + *rate * (time - course->speed_times[k - 1]);
}

whirl_status records_note_run(const whirl_batch *batch, size_t point, const whirl_machine *machine,
                              const whirl_run_motion *motion, const whirl_layout *layout, double *block) {
    const whirl_dataset *dataset = batch->dataset;
    const whirl_dataset_options *options = &batch->record.dataset;
    const whirl_field *field = whirl_layout_field(layout, WHIRL_FIELD_DATASET_SIGNALS);
    if (!dataset || !machine->course || !field) return whirl_ok();
    // Note the record, with the speeds of its first and last sample.
    const double first = records_first_time(batch, machine), last = first + (options->samples - 1) / options->rate;
    double run[3], unused;
    run[0] = records_speed_at(machine->course, first, &run[2]);
    run[1] = records_speed_at(machine->course, last, &unused);
    const whirl_record_of own = records_note_numbers(batch, point, run, layout, block);
    // Sample the motion; a run that ended before its time has no signals.
    float *signals = (float *)(block + field->offset);
    const whirl_sampling sampling = {
        .samples = (size_t)options->samples, .rate = options->rate, .seed = own.seed, .length = machine->length};
    const double *end = block + whirl_layout_field(layout, WHIRL_FIELD_RUNUP_END)->offset;
    if (*end == 0.0 && motion->count > 0 && motion->filled == motion->count)
        return whirl_channels_sample_run(motion, machine->system->probes, (size_t)RUN_MARGIN * WHIRL_SENSOR_INSTANTS,
                                         WHIRL_SENSOR_INSTANTS, dataset->channels, dataset->channel_count, &sampling,
                                         signals);
    for (size_t i = 0; i < dataset->channel_count * sampling.samples; i++) signals[i] = NAN;
    return whirl_ok();
}
