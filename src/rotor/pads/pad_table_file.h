/// Tables in the user's cache folder, $XDG_CACHE_HOME/whirl or ~/.cache/whirl, for later runs.
#ifndef ROTOR_PAD_TABLE_FILE_H
#define ROTOR_PAD_TABLE_FILE_H

#include "pad_table.h"

#include <stdbool.h>
#include <stdint.h>

/// Returns the checksum (Fowler, Noll, Vo 1991) of the coefficients, as words of 64 bits.
uint64_t pad_table_checksum(const pad_table *table);

/// Returns true if there is a file for such a table. Does not read it.
bool pad_table_file_is_there(const pad_table_key *key);

/// Reads the coefficients. *found becomes false if there is no plain file, or if the file is damaged, was written by
/// whirl with other sources of the film's solver, or differs from solved films (pad_table_confirm). Errors as those of
/// pad_table_confirm.
whirl_status pad_table_file_read(const pad_table_key *key, pad_table *table, bool *found);

/// Saves a table for later runs, atomically. A failure is ignored. Removes the least recently used files beyond
/// PAD_TABLE_FILES.
void pad_table_file_write(const pad_table_key *key, const pad_table *table);

enum { PAD_TABLE_FILES = 512 }; ///< most files, of 2 MB each

#endif
