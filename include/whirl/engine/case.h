/// Cases: one YAML file that describes a rotor, its parameters and a study.
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

/// Something wrong in a file. Lines and columns count from 1; 0 where there is no place (a --set on the command line).
typedef struct whirl_problem {
    int line, column;  ///< where, from 1
    char key[128];     ///< path of the key, "rotor.stations.disc.mass"; items of a list count from 1
    char message[256]; ///< "is -3 kg, expected a number above 0 kg"
    /// The line of the file, or what stands around the place in a long one; safe to show on a terminal; "" where there
    /// is none.
    char excerpt[160];
    int mark, marked; ///< characters of it before the place, and those that the problem is about
} whirl_problem;

/// A list of problems, all that were found; starts as {0}. Freed by whirl_problems_free.
typedef struct whirl_problems {
    size_t count, capacity; ///< problems, and how many there is room for
    whirl_problem *items;   ///< [count]
    char file[256];         ///< of the case
} whirl_problems;

/// "paper.yaml:12:7: rotor.stations.disc.mass: is -3 kg, expected ...". Writes at most `size` bytes.
void whirl_problem_text(const whirl_problems *problems, size_t index, char *text, size_t size);
/// All of them, a line each, cut at `size` bytes.
void whirl_problems_text(const whirl_problems *problems, char *text, size_t size);
/// Frees the list, not the struct, which is empty afterwards.
void whirl_problems_free(whirl_problems *problems);

/// Reads and checks a case file. WHIRL_BAD_INPUT when anything is wrong: `problems` then lists all of it (at most 100).
/// Files above 1 MiB, aliases, and nesting deeper than 32 are refused. A file that cannot be read at all (missing, a
/// directory) is WHIRL_BAD_INPUT with a sentence and without problems. `problems` may be NULL.
whirl_status whirl_case_load(const char *path, whirl_problems *problems, whirl_case **out);

/// The same from memory; `name` stands for the file in messages. Never runs long and never crashes, whatever the bytes.
whirl_status whirl_case_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                              whirl_case **out);

/// The same, of the parameter that a sweep varies, too: for programs that vary another one than the case does.
whirl_status whirl_case_assign(whirl_case *object, const char *assignment);

/// What the study of the case may spend on points in doubt (whirl_study.refine); nothing where it is not called.
void whirl_case_refine(whirl_case *object, whirl_budget budget);

/// Reads a number as cases have it: in SI, "628", or with any unit of the dimension of `unit`, "6000 rpm" for "rad/s";
/// of any dimension where that is "". WHIRL_BAD_INPUT with a sentence for anything else.
whirl_status whirl_quantity_value(const char *text, const char *unit, double *value);

/// Value of a parameter in SI. WHIRL_BAD_INPUT for an unknown name.
whirl_status whirl_case_parameter(const whirl_case *object, const char *name, double *value);

/// Its speed of rotation in rad/s with parameter `name` at `value` (name NULL: as the case says).
whirl_status whirl_case_speed(const whirl_case *object, const char *name, double value, double *speed);

/// The rotor with parameter `name` at `value` (name NULL: as the case says), built to move where a part of the study
/// does (whirl_design_in_time). Freed by whirl_rotor_free. Thread-safe.
whirl_status whirl_case_rotor(const whirl_case *object, const char *name, double value, whirl_rotor **rotor);

/// The same as an outline, to be looked at (whirl_rotor_outline).
whirl_status whirl_case_rotor_outline(const whirl_case *object, const char *name, double value, whirl_rotor **rotor);

/// One element of the case alone: the stations of the case, each a free mass of 1 kg, on which that element acts, so
/// that their accelerations (whirl_rotor_rates) are its forces in N; gravity's are those on 1 kg. `element` is its kind
/// ("film"), or "film[2]" for the second of that kind. WHIRL_BAD_INPUT where there is no such element, or where it
/// needs what free masses do not have (tilts, shafts of finite elements). Freed by whirl_rotor_free.
whirl_status whirl_case_element(const whirl_case *object, const char *element, whirl_rotor **rotor);

/// Its shafts of finite elements with the parameters as they are, as whirl_design_shafts tells of them.
whirl_status whirl_case_shafts(const whirl_case *object, whirl_shaft_summary out[WHIRL_MAX_SHAFTS], size_t *count);

/// The study of the case. It borrows from the case, which must outlive it.
whirl_status whirl_case_study(const whirl_case *object, whirl_study *study);

/// Fills the parts of a result that the case knows: title, text, scales (of every point of its tables, too),
/// parameters, stations, contacts.
whirl_status whirl_case_describe_result(const whirl_case *object, whirl_result *result);

/// Runs the case's study and describes the result, provenance included: the whole way in one call.
/// Errors as whirl_study_run; stopped, it gives a partial result too.
whirl_status whirl_case_run(const whirl_case *object, const whirl_run_options *options, whirl_result **result);

/// Runs the study of something that has one, as whirl_case_run.
typedef whirl_status whirl_job_run_fn(const void *subject, const whirl_run_options *options, whirl_result **result);

/// A job of any such subject, which must outlive it (whirl_job_new). WHIRL_NO_MEMORY. Freed by whirl_job_free.
whirl_status whirl_job_of(whirl_job_run_fn *run, const void *subject, whirl_job **job);

/// A key of the case whose value is an expression with a parameter.
typedef struct whirl_use {
    const char *parameter; ///< its name
    const whirl_key *key;  ///< where it is used
    char path[128];        ///< of the key, as in whirl_problem
    bool alone;            ///< the parameter alone stands there ("= c")
} whirl_use;

/// Is told of every use.
typedef void (*whirl_case_use_fn)(void *context, const whirl_use *use);

/// Tells of every use of every parameter in rotor, stations, elements and initial states.
void whirl_case_uses(const whirl_case *object, whirl_case_use_fn see, void *context);

/// What the case says of a parameter: the comment on its line, "" where there is none or others stand there too. Writes
/// at most `size` bytes.
void whirl_case_comment(const whirl_case *object, const char *name, char *comment, size_t size);

/// The text of a case with `value` at the key `path` ("parameters.r_k", "study.sweep.from"), all else as it was; a key
/// that is missing is added where its mapping stands. A list of values is replaced by another in brackets, "[1 mm, 2
/// mm]". `value` NULL takes the key and its value out; without the key the text stays as it is. *edited is freed by the
/// caller. WHIRL_BAD_INPUT for a text that is not YAML, or a place that takes no value. What the new text means is not
/// checked: see whirl_case_parse.
whirl_status whirl_case_edit(const char *text, size_t length, const char *path, const char *value, char **edited);

/// The groups of keys of a case file outside rotor elements and stations (case, rotor, study, sweep, integrate, ...);
/// static, ended by NULL. A key of kind WHIRL_KEY_CHOICE whose choices are "" holds a text, or a part with keys of its
/// own.
const whirl_group *const *whirl_case_groups(void);

#ifdef __cplusplus
}
#endif
#endif
