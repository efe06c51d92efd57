/// Tables in files of their own: readings of a file on balancing, laws over the time of a run.
#ifndef CASE_TABLE_FILE_H
#define CASE_TABLE_FILE_H

#include "parameters.h"

/// Reads comma-separated values (or values separated by semicolons or tabs) under headings that are keys of the group,
/// with units after them ("amplitude [um]"). Returns the equivalent list of mappings; NULL after a problem. The reader
/// has no problems before; afterwards it has those of the table.
const file_node *table_read(case_reader *reader, const char *path, const whirl_group *group);

/// Reports problems of a table where the file names it, each with its line and column in the table.
void table_take_problems(case_reader *reader, const file_node *where, const whirl_problems *of);

#endif
