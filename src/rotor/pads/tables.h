/// The tables of all pads of the process, by number: each is made once and lasts.
#ifndef ROTOR_PAD_TABLES_H
#define ROTOR_PAD_TABLES_H

#include "table.h"

enum { MAX_PAD_TABLES = 4096 };

/// The number of the table of such a pad. WHIRL_BAD_INPUT for more tables than MAX_PAD_TABLES.
whirl_status pad_table_number(const pad_table_key *key, double *number);

/// What that is of.
pad_table_key pad_table_key_of(double number);

/// The table of a number. Where it is asked for first it is read from the user's cache folder ($XDG_CACHE_HOME/whirl,
/// or ~/.cache/whirl) if it is whole there, else it is made, which takes seconds, and left there. Not-a-numbers where
/// there is no memory for it: what moves by it diverges.
const pad_table *pad_table_of(double number);

#endif
