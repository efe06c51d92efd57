/// A fit: unknown parameters, and tables of measured numbers.
#ifndef CASE_PLAN_FIT_H
#define CASE_PLAN_FIT_H

#include "machine.h"
#include "plan_course.h"
#include "plan_parts.h"
#include "whirl/engine/study.h"

#include <stddef.h>

/// Maximum number of parameters whose values a table of measured numbers sets.
enum { FIT_MAX_AT = WHIRL_MAX_GIVEN - WHIRL_MAX_UNKNOWNS - 1 };

/// Maximum number of probes of a table that have their own noise.
enum { FIT_MAX_CHANNELS = 32 };

typedef struct fit_unknown {
    const file_node *place;
    setting_list keys;
    const parameter *parameter; ///< NULL after a problem
    number_formula start, low, high;
} fit_unknown;

/// A probe with its noise.
typedef struct fit_channel {
    const file_node *place; ///< its key is the probe's heading
    number_formula noise;
} fit_channel;

/// A table of measured numbers, or a single number.
typedef struct fit_set {
    const file_node *place, *file; ///< place of the set in the case, and of a table's path; NULL after a problem
    const file_node *columns;      ///< headings with datasets of an HDF5 file; NULL: its vectors
    setting_list keys;
    setting_list *runup;            ///< keys of the run in which it was measured; NULL: none
    const course_parts *course;     ///< events and laws of that run, or NULL
    condition_parts at;             ///< parameters with their values in its motions
    whirl_key noise_key;            ///< unit and range of its noise
    number_formula noise;           ///< noise of all probes; unused if each channel has its own
    const parameter *along;         ///< parameter whose value the threshold is; NULL: the speed
    number_formula value, from, to; ///< a threshold, and values between which it is sought
    size_t channel_count;
    fit_channel channels[FIT_MAX_CHANNELS];
} fit_set;

typedef struct fit_parts {
    setting_list keys;
    const machine_parts *machine;
    size_t unknown_count, set_count;
    fit_unknown unknowns[WHIRL_MAX_UNKNOWNS];
    fit_set sets[WHIRL_MAX_FIT_SETS];
} fit_parts;

/// Reads the keys of a fit; NULL without memory.
const fit_parts *fit_read(case_reader *reader, const machine_parts *machine, const setting_list *keys);

/// Reads the tables, and completes the batch of a fit, whose options are set. Tables that cannot be read are not
/// reported: the study is refused (whirl_fit.trouble).
void fit_make(case_reader *reader, valuation *v, const fit_parts *parts, whirl_batch *batch);

#endif
