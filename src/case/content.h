/// What a case is made of.
#ifndef CASE_CONTENT_H
#define CASE_CONTENT_H

#include "machine.h"
#include "parameters.h"
#include "plan.h"
#include "whirl/engine/case.h"

enum { DOCUMENT_TEXT = 160 };

/// Everything that follows from the text and the overrides; replaced as a whole by whirl_case_set.
typedef struct case_content {
    memory_arena arena;
    const file_node *root; ///< the file as it was read
    char title[256];
    setting_list document; ///< schema_document's keys; without items where the case has none
    char units[64];        ///< of figures (base/words/words.h), "" where the case chooses none
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
    whirl_budget refine; ///< no part of the file
};

/// Whether an expression depends on a parameter, itself or by others that it names (uses.c).
bool case_depends(const case_content *content, const char *expression, const char *name);

/// The first number of some settings that depends on a parameter, those in lists included; NULL where none does.
const setting *case_list_depends(const case_content *content, const setting_list *list, const char *name);

/// The first setting of the machine, its initial state left out, that depends on a parameter; NULL where none does.
const setting *case_machine_use(const case_content *content, const char *name);

/// A machine of the family that a case is: the rotor with one parameter at a value, and its initial state.
whirl_status case_machine(const void *family, const whirl_batch *batch, double value, whirl_machine *machine);

// ---------------------------------------------------------------- fits
// What stands in time for tables over the frequency of whirl: rational functions, said with their errors, and whether
// they leave the machine as stable as its tables do.

/// Adds a fact to the result, "fit 1", ..., for every such function of the machine with these parameters [count], where
/// it is not there yet. `doubt` is what to warn of: modes that functions and tables take for stable and for unstable,
/// "" where there are none. Machines without such tables, and what cannot be built, are left out: WHIRL_NO_MEMORY
/// alone.
whirl_status case_tell_fits(const case_content *content, const whirl_given *given, size_t count, whirl_result *result,
                            char doubt[WHIRL_MESSAGE_SIZE]);

// ---------------------------------------------------------------- warn
// What a case may say and likely does not mean.

/// Adds a fact to the result for every warning (whirl_result_warning): keys without what they are
/// of, values that the law of an element is not for, at the ends of what the study varies, ranges without extent, and
/// what stands in time for tables (content.h).
whirl_status case_warn(const case_content *content, whirl_result *result);

#endif
