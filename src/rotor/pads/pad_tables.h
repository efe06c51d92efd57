/// Tables of the films of pads.
#ifndef ROTOR_PAD_TABLES_H
#define ROTOR_PAD_TABLES_H

#include "pad_table.h"
#include "whirl/engine/stop.h"

// Tables of all pads of the process, by number. Machines hold the tables of their pads. A table is read from its file,
// or made, when it is first held; it is freed some time after its last holder has released it.

/// Largest number of unused tables in memory, of 4 MB each.
enum { MAX_IDLE_PAD_TABLES = 64 };

/// Returns the number of a pad's table, which need not exist yet. WHIRL_BAD_INPUT for more tables than
/// WHIRL_MAX_FILM_TABLES.
whirl_status pad_table_number(const pad_table_key *key, double *number);

/// Returns the key of a number.
pad_table_key pad_table_key_of(double number);

/// Provides the table until pad_table_release. To make it takes a second; all threads that want the table make it
/// together, and give up when *stop becomes true (NULL: never). If a film cannot be solved the table contains NaN, with
/// which motions diverge. After WHIRL_NO_MEMORY and WHIRL_STOPPED the table is not provided.
whirl_status pad_table_hold(double number, const whirl_stop *stop);
void pad_table_release(double number);

/// Returns the table of a number if it is provided, otherwise a table of zeros.
const pad_table *pad_table_of(double number);

#endif
