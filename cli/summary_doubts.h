/// What the summary says of undetermined motions.
#ifndef CLI_SUMMARY_DOUBTS_H
#define CLI_SUMMARY_DOUBTS_H

#include "whirl/result.h"

/// Why motions of a table are undetermined, how many for one reason, and what would tell them; nothing where none is.
void summarize_doubts(const whirl_result *result, const whirl_table *table);

#endif
