// Fields of the records of a data set: machine, label and condition of each, and its signals.
#include <math.h>
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
    {WHIRL_FIELD_DATASET_SPEED, "rad/s", "speed of the shaft"},
};
enum { RECORD_NUMBERS = sizeof record_numbers / sizeof *record_numbers };

whirl_status records_add_fields(const whirl_batch *batch, whirl_layout *layout) {
    const whirl_dataset_options *options = &batch->record.dataset;
    if (!batch->dataset) return whirl_ok();
    if (layout->field_count + RECORD_NUMBERS + 2 > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields",
                          WHIRL_MAX_FIELDS - RECORD_NUMBERS - 2);
    for (size_t i = 0; i < RECORD_NUMBERS; i++)
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

whirl_status records_note(const whirl_batch *batch, size_t point, const whirl_machine *machine,
                          const whirl_record *record, const whirl_layout *layout, double *block) {
    const whirl_field *first = whirl_layout_field(layout, record_numbers[0].name);
    const whirl_field *values = whirl_layout_field(layout, WHIRL_FIELD_DATASET_VALUES);
    const whirl_field *signals = whirl_layout_field(layout, WHIRL_FIELD_DATASET_SIGNALS);
    if (!batch->dataset || !first || !signals) return whirl_ok();
    const whirl_record_of own =
        whirl_dataset_record(batch->dataset, &batch->record.dataset, point, values ? block + values->offset : NULL);
    const double numbers[RECORD_NUMBERS] = {(double)own.number, (double)own.machine, (double)own.label, own.severity,
                                            (double)own.split,  (double)own.seed,    own.begin,         machine->speed};
    memcpy(block + first->offset, numbers, sizeof numbers);
    return records_sample(batch, &own, machine, record, (float *)(block + signals->offset));
}
