/// The course of a run: its events, and its laws of speed, torque and ground.
#ifndef CASE_PLAN_COURSE_H
#define CASE_PLAN_COURSE_H

#include "machine.h"
#include "plan_parts.h"
#include "whirl/engine/study.h"

#include <stddef.h>

/// An event as it is written in the case.
typedef struct course_event {
    const file_node *place;
    setting_list keys; ///< its keys, or those of the run
    bool alone;        ///< it is the change that the run's own keys give
    const char *name;  ///< or NULL
    size_t after;      ///< index of the event before, or WHIRL_NO_EVENT
    const char *when;  ///< formula, or NULL
    size_t spool;      ///< shaft whose speed and motor are meant: 0 the rotor's, from 1 one with a speed of its own
    size_t station;    ///< station at which an unbalance appears; the number of stations: none
    bool trip, end;
    condition_parts change; ///< parameters that change
} course_event;

/// A row of a table over the time.
typedef struct course_row {
    const file_node *place;
    number_formula time, value;
} course_row;

/// A table over the time: of the case, or of a file.
typedef struct course_table {
    size_t count;
    course_row *rows; ///< [count]
} course_table;

/// The course of a shaft with a speed of its own.
typedef struct course_shaft {
    const char *name;
    const file_node *place; ///< NULL: the run says nothing of it
    setting_list keys;
    course_table speeds;                        ///< over the time, or over the rotor's speed
    bool by_rotor;                              ///< the latter
    const char *formulas[WHIRL_SPOOL_FORMULAS]; ///< in the order of WHIRL_SPOOL_SPEED, or NULL
} course_shaft;

typedef struct course_parts {
    size_t shaft_count;
    course_shaft shafts[WHIRL_MAX_SPOOLS]; ///< [shaft_count] in the order of whirl_system.spools
    size_t event_count;
    course_event events[WHIRL_MAX_EVENTS];
    course_table speeds;
    const char *laws[WHIRL_FORMULA_EVENT];    ///< formulas in the order of whirl_run_formula, or NULL
    course_table tables[WHIRL_FORMULA_EVENT]; ///< ... or tables in their place
} course_parts;

/// A course with the values of a point.
typedef struct course_run course_run;

/// Reads the course from the keys of a run; NULL if there is none, or no memory.
const course_parts *course_read(case_reader *reader, const machine_parts *machine, setting_list *keys);

/// Evaluates the expressions of a course and reports wrong ones. Returns false if there are any.
bool course_check(case_reader *reader, valuation *v, const course_parts *parts);

/// Writes the number and the names of the shafts with a speed of their own to the options of a run.
void course_name_shafts(const course_parts *parts, whirl_runup_options *options);

/// Makes the course at a point, of a machine with that unit of displacement, m. *out is freed by course_free, after a
/// failure, too.
whirl_status course_make(const course_parts *parts, const machine_parts *machine, valuation *v, double length,
                         course_run **out);

/// Completes the laws of the shafts with a speed of their own, of a machine whose run has that length, s.
/// WHIRL_BAD_INPUT with a sentence for laws that contradict each other, or give no speed.
whirl_status course_make_shafts(const course_parts *parts, valuation *v, const whirl_system *system, double duration,
                                course_run *run);
const whirl_run_course *course_shown(const course_run *run);

/// Checks that the laws of a course have values at time 0, at a speed in rad/s, and that their tables reach the end of
/// the run, s. WHIRL_BAD_INPUT with a sentence.
whirl_status course_covers(const course_run *run, double speed, double end);
void course_free(course_run *run);

/// Sets the speeds of a run without a table, rad/s and rad/s2: from `from` to `to` at the rate `rate`, then constant.
void course_set_rate(course_run *run, double from, double to, double rate);

/// Prepends `lead` seconds at the first speed to the table of speeds; times of events and in formulas count from their
/// end. WHIRL_BAD_INPUT if the table has too many rows.
whirl_status course_lead(course_run *run, double lead);

/// Adds the values that an event gives to parameters behind given [*count], at most WHIRL_MAX_GIVEN.
whirl_status course_given(const course_parts *parts, size_t event, valuation *v, whirl_given *given, size_t *count);

#endif
