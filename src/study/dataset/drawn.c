// Draws machines, labels, severities, conditions and seeds of the records of a data set.
#include <math.h>

#include "random.h"
#include "whirl/engine/dataset.h"

const char *whirl_split_name(whirl_split split) {
    static const char *const names[] = {"train", "validation", "test"};
    return names[split];
}

size_t whirl_dataset_records(const whirl_dataset_options *options) {
    if (options->only > 0) return 1;
    return (size_t)options->machines * (size_t)options->labels * (size_t)options->records;
}

/// Samples before the first one of a run, in which sensors and their filters settle.
enum { LEAD_SAMPLES = 2 * WHIRL_SENSOR_REACH };

double whirl_dataset_lead(const whirl_dataset_options *options, double speed) {
    return speed > 0.0 ? LEAD_SAMPLES / options->rate : 0.0;
}

double whirl_dataset_duration(const whirl_dataset_options *options, double lead) {
    return lead + (options->samples + LEAD_SAMPLES) / options->rate;
}

/// Purposes of random numbers; numbers for different purposes are independent.
enum { DRAWN_MACHINE, DRAWN_SPLIT, DRAWN_CONDITION, DRAWN_SEVERITY, DRAWN_LABEL, DRAWN_SEED, DRAWN_BEGIN };

/// Returns a random number of a machine or record, from 0, for a purpose and a parameter.
static double drawn_share(const whirl_dataset_options *options, unsigned purpose, size_t of, size_t parameter) {
    return random_share(random_next((uint64_t)(unsigned)options->seed, purpose), of, parameter);
}

static void draw_values(const whirl_dataset_options *options, unsigned purpose, size_t of, size_t count,
                        const whirl_drawn *drawn, double *values) {
    for (size_t i = 0; i < count; i++)
        values[drawn[i].parameter] =
            whirl_tolerance_value(&drawn[i].of, drawn_share(options, purpose, of, drawn[i].parameter));
}

/// Returns the set of a machine. Successive machines have places that differ by the golden ratio, so that the shares of
/// the sets are right for few machines as well as for many.
static whirl_split split_of(const whirl_dataset_options *options, size_t machine) {
    const double golden = 0.618033988749894848205;
    double whole;
    const double place = modf(drawn_share(options, DRAWN_SPLIT, 0, 0) + golden * (double)machine, &whole);
    if (place < options->train) return WHIRL_SPLIT_TRAIN;
    return place < options->train + options->validation ? WHIRL_SPLIT_VALIDATION : WHIRL_SPLIT_TEST;
}

whirl_record_of whirl_dataset_record(const whirl_dataset *dataset, const whirl_dataset_options *options, size_t index,
                                     double *values) {
    const size_t record = options->only > 0 ? (size_t)options->only - 1 : index, each = (size_t)options->records;
    const size_t machine = record / (each * dataset->label_count);
    const uint64_t seeds = random_next((uint64_t)(unsigned)options->seed, DRAWN_SEED);
    whirl_record_of own = {.number = record + 1,
                           .machine = machine + 1,
                           .label = record / each % dataset->label_count,
                           .severity = NAN,
                           .split = split_of(options, machine),
                           .seed = random_bits(seeds, record, 0) >> 11,
                           .begin = drawn_share(options, DRAWN_BEGIN, record, 0)};
    const whirl_label *label = &dataset->labels[own.label];
    if (label->graded_count > 0) own.severity = drawn_share(options, DRAWN_SEVERITY, record, 0);
    if (!values) return own;
    for (size_t i = 0; i < dataset->parameter_count; i++) values[i] = dataset->values[i];
    draw_values(options, DRAWN_MACHINE, machine, dataset->machine_count, dataset->machine, values);
    draw_values(options, DRAWN_CONDITION, record, dataset->condition_count, dataset->conditions, values);
    draw_values(options, DRAWN_LABEL, record, label->varied_count, label->varied, values);
    for (size_t i = 0; i < label->graded_count; i++) {
        const whirl_graded *graded = &label->graded[i];
        values[graded->parameter] = graded->from + own.severity * (graded->to - graded->from);
    }
    return own;
}
