/// Cases: YAML files that describe a rotor, its parameters and a study.
#ifndef WHIRL_CASE_H
#define WHIRL_CASE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"
#include "whirl/job.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A problem in a file. Lines and columns count from 1; 0 if it has no place in the file (--set on the command line).
typedef struct whirl_problem {
    int line, column;  ///< its place, from 1
    char key[128];     ///< path of the key, "rotor.stations.disc.mass"; items of a list count from 1
    char message[256]; ///< "is -3 kg, expected a number above 0 kg"
    /// The line of the file, or the part of a long line around the place; safe to show on a terminal; "" if it has no
    /// place.
    char excerpt[160];
    int mark, marked; ///< characters of the excerpt before the place, and characters to underline
} whirl_problem;

/// All problems that were found; starts as {0}. Freed by whirl_problems_free.
typedef struct whirl_problems {
    size_t count, capacity; ///< number of problems, and allocated number
    whirl_problem *items;   ///< [count]
    char file[256];         ///< name of the case file
} whirl_problems;

/// Writes a problem as "paper.yaml:12:7: rotor.stations.disc.mass: is -3 kg, expected ...", at most `size` bytes.
void whirl_problem_text(const whirl_problems *problems, size_t index, char *text, size_t size);
/// Writes all problems, a line each, cut at `size` bytes.
void whirl_problems_text(const whirl_problems *problems, char *text, size_t size);
/// Frees the contents; the struct is empty afterwards.
void whirl_problems_free(whirl_problems *problems);

/// Reads and checks a case file. WHIRL_BAD_INPUT if anything is wrong: `problems` then lists all of it (at most 100).
/// Refuses files above 1 MiB, aliases, and nesting deeper than 32. A file that cannot be read (missing, a directory) is
/// WHIRL_BAD_INPUT with a sentence and without problems. `problems` may be NULL.
whirl_status whirl_case_load(const char *path, whirl_problems *problems, whirl_case **out);

/// Does the same from memory; `name` is the file's name in messages. Ends soon and never crashes, for any bytes.
whirl_status whirl_case_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                              whirl_case **out);

/// Does whirl_case_set, and also accepts the swept parameter: for programs that vary another parameter than the case
/// does.
whirl_status whirl_case_assign(whirl_case *object, const char *assignment);

/// Sets the budget of the case's study for points in doubt (whirl_study.refine); the default is none.
void whirl_case_refine(whirl_case *object, whirl_budget budget);

/// Reads a number as in cases: in SI, "628", or with any unit of the dimension of `unit`, "6000 rpm" for "rad/s"; of
/// any dimension if `unit` is "". WHIRL_BAD_INPUT with a sentence for anything else.
whirl_status whirl_quantity_value(const char *text, const char *unit, double *value);

/// Returns the value of a parameter in SI. WHIRL_BAD_INPUT for an unknown name.
whirl_status whirl_case_parameter(const whirl_case *object, const char *name, double *value);

/// Computes the speed of rotation in rad/s with parameter `name` at `value` (name NULL: as in the case).
whirl_status whirl_case_speed(const whirl_case *object, const char *name, double value, double *speed);

/// Builds the rotor with parameter `name` at `value` (name NULL: as in the case), for motions in time if a part of the
/// study computes motions (whirl_design_in_time). Freed by whirl_rotor_free. Thread-safe.
whirl_status whirl_case_rotor(const whirl_case *object, const char *name, double value, whirl_rotor **rotor);

/// Builds the same rotor as an outline, for inspection (whirl_rotor_outline).
whirl_status whirl_case_rotor_outline(const whirl_case *object, const char *name, double value, whirl_rotor **rotor);

/// Builds a rotor of one element of the case: the stations of the case as free masses of 1 kg, on which only that
/// element acts, so that their accelerations (whirl_rotor_rates) are its forces in N; for gravity the forces on 1 kg.
/// `element` is a kind ("film"), or "film[2]" for the second of a kind. WHIRL_BAD_INPUT if there is no such element, or
/// it needs coordinates that free masses lack (tilts, shafts of finite elements). Freed by whirl_rotor_free.
whirl_status whirl_case_element(const whirl_case *object, const char *element, whirl_rotor **rotor);

/// Summarizes the case's finite-element shafts at its own parameters, as whirl_design_shafts.
whirl_status whirl_case_shafts(const whirl_case *object, whirl_shaft_summary out[WHIRL_MAX_SHAFTS], size_t *count);

/// Fills the study of the case. It borrows from the case, which must outlive it.
whirl_status whirl_case_study(const whirl_case *object, whirl_study *study);

/// Fills the parts of a result that come from the case: title, text, scales (also of every point of its tables),
/// parameters, stations, contacts.
whirl_status whirl_case_describe_result(const whirl_case *object, whirl_result *result);

/// Runs the case's study and describes the result, provenance included. Errors as whirl_study_run; a stopped run gives
/// a partial result, too.
whirl_status whirl_case_run(const whirl_case *object, const whirl_run_options *options, whirl_result **result);

/// Runs the study of a subject, as whirl_case_run does for a case.
typedef whirl_status whirl_job_run_fn(const void *subject, const whirl_run_options *options, whirl_result **result);

/// Creates a job of such a subject, which must outlive it (whirl_job_new). WHIRL_NO_MEMORY. Freed by whirl_job_free.
whirl_status whirl_job_of(whirl_job_run_fn *run, const void *subject, whirl_job **job);

/// A key of the case whose value is an expression with a parameter.
typedef struct whirl_use {
    const char *parameter; ///< its name
    const whirl_key *key;  ///< the key that uses it
    char path[128];        ///< path of the key, as in whirl_problem
    bool alone;            ///< the expression is the parameter alone ("= c")
} whirl_use;

/// Receives a use of a parameter.
typedef void (*whirl_case_use_fn)(void *context, const whirl_use *use);

/// Reports every use of every parameter in rotor, stations, elements and initial states.
void whirl_case_uses(const whirl_case *object, whirl_case_use_fn see, void *context);

/// A number that the case writes as such, not as an expression, and that whirl_case_set can change.
typedef struct whirl_written_number {
    char name[128];       ///< as whirl_case_set takes it: "disc.eccentricity", "rub[2].friction", "runup.rate"
    const whirl_key *key; ///< its descriptor
    const char *text;     ///< as written, "0.003 rad/s2"
    double value;         ///< in the unit of the key
} whirl_written_number;

/// Receives such a number; it is valid during the call.
typedef void (*whirl_case_number_fn)(void *context, const whirl_written_number *number);

/// Reports the numbers of the run-up, of stations and of elements that the case writes as such, in this order. Numbers
/// of several run-ups have no names and are left out.
void whirl_case_numbers(const whirl_case *object, whirl_case_number_fn see, void *context);

/// Writes the comment of the case on a parameter's line, at most `size` bytes; "" if there is none or the line has
/// several parameters.
void whirl_case_comment(const whirl_case *object, const char *name, char *comment, size_t size);

/// Removes a key with everything below it from the text of a case, if it is there, and leaves the rest unchanged.
/// *edited is freed by the caller. WHIRL_BAD_INPUT for a text that is not YAML, and for items of lists.
whirl_status whirl_case_remove(const char *text, size_t length, const char *path, char **edited);

/// Edits the text of a case: sets the key `path` ("parameters.r_k", "study.sweep.from") to `value` and leaves the rest
/// unchanged. Adds a missing key to its mapping. A list of values is replaced by a list in brackets, "[1 mm, 2 mm]".
/// `value` NULL removes the key, if it is there. *edited is freed by the caller. WHIRL_BAD_INPUT for a text that is not
/// YAML, or a place that takes no value. Use whirl_case_parse to check the new text.
whirl_status whirl_case_edit(const char *text, size_t length, const char *path, const char *value, char **edited);

/// Returns the groups of keys of a case file outside of rotor elements and stations (case, rotor, study, sweep,
/// integrate, ...); static, ended by NULL. A key of kind WHIRL_KEY_CHOICE with choices "" holds a text, or a part with
/// keys of its own.
const whirl_group *const *whirl_case_groups(void);

#ifdef __cplusplus
}
#endif
#endif
