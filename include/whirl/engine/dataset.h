/// Data sets: records of machines with known faults, for diagnosis (study `dataset`).
///
/// Records are of motions at constant speeds, or of runs whose speed follows a law of time.
///
/// A data set has `machines` machines, which differ within their tolerances. Each machine has every label, in `records`
/// records under different conditions. The contents of a record depend only on the data set and the number of the
/// record, so that any single record can be computed again. Records are divided by machine into sets for training,
/// validation and testing, since records of one machine resemble one another.
#ifndef WHIRL_DATASET_H
#define WHIRL_DATASET_H

#include <stddef.h>
#include <stdint.h>

#include "whirl/engine/sensors.h"
#include "whirl/engine/tolerances.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of data sets.
enum {
    WHIRL_MAX_LABELS = 32,             ///< labels
    WHIRL_MAX_DRAWN = 32,              ///< parameters that differ between records
    WHIRL_MAX_RECORDS = 1 << 24,       ///< records
    WHIRL_MAX_RECORD_SAMPLES = 1 << 22 ///< samples of a channel
};

/// A parameter with a distribution.
typedef struct whirl_drawn {
    size_t parameter;   ///< index among those of the data set
    whirl_tolerance of; ///< its distribution
} whirl_drawn;

/// A parameter that the severity of a fault sets: from + severity (to - from).
typedef struct whirl_graded {
    size_t parameter; ///< index among those of the data set
    double from, to;  ///< SI
} whirl_graded;

/// A label: a state of machines, and how it changes their parameters.
typedef struct whirl_label {
    const char *name;           ///< borrowed
    size_t graded_count;        ///< 0: the label has no severity
    const whirl_graded *graded; ///< [graded_count] borrowed
    size_t varied_count;        ///< number of varied parameters
    const whirl_drawn *varied;  ///< [varied_count] parameters that differ between its records; borrowed
} whirl_label;

/// A data set: variations between its records. A parameter without a distribution has its value in the case. If several
/// lists vary a parameter, the list of the label takes precedence over that of conditions, and that of conditions over
/// that of machines.
typedef struct whirl_dataset {
    size_t parameter_count, machine_count, condition_count, label_count, channel_count; ///< lengths of the lists
    const char *const *parameters; ///< [parameter_count] names; borrowed, as all lists
    const double *values;          ///< [parameter_count] their values in the case, SI
    const whirl_drawn *machine;    ///< [machine_count] differ between machines
    const whirl_drawn *conditions; ///< [condition_count] differ between records
    const whirl_label *labels;     ///< [label_count]
    const whirl_channel *channels; ///< [channel_count]
} whirl_dataset;

/// Returns the number of records of a data set that are made.
size_t whirl_dataset_records(const whirl_dataset_options *options);

/// Returns the lead of a run: the time, s, from its beginning to the first sample of its record. During the lead the
/// shaft turns at `speed`, rad/s, the first speed of the run's law. 0 if that speed is 0.
double whirl_dataset_lead(const whirl_dataset_options *options, double speed);

/// Returns the duration, s, of the run of a record with that lead: lead, samples, and the time that the filters need
/// after the samples.
double whirl_dataset_duration(const whirl_dataset_options *options, double lead);

/// The set that a record belongs to.
typedef enum whirl_split { WHIRL_SPLIT_TRAIN, WHIRL_SPLIT_VALIDATION, WHIRL_SPLIT_TEST } whirl_split;

/// Returns its name: "train", "validation", "test"; static.
const char *whirl_split_name(whirl_split split);

/// The machine, faults and condition of a record.
typedef struct whirl_record_of {
    size_t number;     ///< its number, from 1
    size_t machine;    ///< number of its machine, from 1
    size_t label;      ///< index of its label
    double severity;   ///< above 0, below 1; NaN if the label has none
    whirl_split split; ///< set of its machine
    uint64_t seed;     ///< seed of its noise and jitter; below 2^53
    double begin;      ///< revolutions from the end of the lead to the first sample, below 1; for a run, the angle of
                       ///< the shaft at the first sample, in revolutions
} whirl_record_of;

/// Returns the machine, label, severity and condition of a record, by its index among those that are made, and writes
/// its parameters, SI, to values [parameter_count] (unless NULL).
whirl_record_of whirl_dataset_record(const whirl_dataset *dataset, const whirl_dataset_options *options, size_t index,
                                     double *values);

#ifdef __cplusplus
}
#endif
#endif
