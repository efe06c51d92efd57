/// Files of a data set that are written next to its result.
#ifndef CLI_RECORDS_H
#define CLI_RECORDS_H

#include <stdbool.h>

#include "whirl/engine/result.h"

/// Returns true if none of the files of `outline`'s records exists next to `output`, or the study has no records;
/// otherwise reports an error.
bool record_files_are_free(const whirl_result *outline, const char *output);

/// Writes the table and the data sheet of a result's records next to its file `output`, with "-records.csv" and
/// "-datasheet.md" in place of ".h5". Results of other studies have no records, and nothing is written. Existing files
/// are replaced. Returns the exit status, after reporting errors.
int write_record_files(const whirl_result *result, const char *output);

#endif
