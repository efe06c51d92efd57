/// Content of a case.
#ifndef CASE_CONTENT_H
#define CASE_CONTENT_H

#include "machine.h"
#include "parameters.h"
#include "schema.h"
#include "whirl/engine/case.h"

enum { DOCUMENT_TEXT = 160 };

/// Everything that follows from the text and the overrides; replaced as a whole by whirl_case_set.
typedef struct case_content {
    memory_arena arena;
    const file_node *root; ///< the file as it was read
    char title[256];
    setting_list document; ///< keys of schema_document; empty if the case has none
    char units[64];        ///< units of figures (base/words/unit_words.h), "" if the case chooses none
    parameter_table parameters;
    machine_parts machine;
    study_plan plan;
    size_t override_count;
    parameter_override *overrides;
} case_content;

struct whirl_case {
    char name[256];
    char *text; ///< byte for byte, with a final zero beyond `length`
    size_t length;
    case_content content;
    whirl_budget refine; ///< budget of refinement; not part of the file
};

/// Returns true if an expression depends on a parameter, directly or through other parameters (uses.c).
bool case_depends(const case_content *content, const char *expression, const char *name);

/// Returns true if an expression depends on a parameter that a batch varies or sets.
bool case_depends_on_batch(const case_content *content, const char *expression, const whirl_batch *batch);

/// Returns the first number of some settings (including lists) that depends on a parameter; NULL if none does.
const setting *case_list_depends(const case_content *content, const setting_list *list, const char *name);

/// Returns the first setting of the machine, except its initial state, that depends on a parameter; NULL if none does.
const setting *case_machine_use(const case_content *content, const char *name);

/// Makes a machine of the case's family: the rotor with the batch's parameter at a value, and its initial state.
whirl_status case_machine(const void *family, const whirl_batch *batch, double value, whirl_machine *machine);

// ---------------------------------------------------------------- fits
// Rational functions that replace frequency-dependent tables in motions: their errors, and whether they change the
// machine's stability.

/// Adds a fact "fit 1", ..., to the result for every function that replaces a table in the machine with these
/// parameters [count], unless the fact exists. `doubt` is a warning about modes that are stable with the functions but
/// unstable with the tables or vice versa; "" if there are none. Machines without such tables, and those that cannot be
/// built, are skipped: only WHIRL_NO_MEMORY is returned.
whirl_status case_tell_fits(const case_content *content, const whirl_given *given, size_t count, whirl_result *result,
                            char doubt[WHIRL_MESSAGE_SIZE]);

// ---------------------------------------------------------------- warn
// Warnings about valid input that is probably not meant.

/// Adds a fact to the result for every warning (whirl_result_warning): keys without the key they belong to, values
/// outside an element's validity at the ends of the study's ranges, empty ranges, and functions that replace tables.
whirl_status case_warn(const case_content *content, whirl_result *result);

#endif
