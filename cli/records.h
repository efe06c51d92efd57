/// Files that lie beside the result of a data set.
#ifndef CLI_RECORDS_H
#define CLI_RECORDS_H

#include <stdbool.h>

#include "whirl/engine/result.h"

/// Writes the table and the data sheet of a result's records beside its file `output`: "-records.csv" and
/// "-datasheet.md" in place of ".h5". Results of other studies have none. Existing files need `force`. Returns the exit
/// status, after reporting errors.
int write_record_files(const whirl_result *result, const char *output, bool force);

#endif
