/// The tables of all pads of the process, by number: each is made once and lasts.
#ifndef ROTOR_PAD_TABLES_H
#define ROTOR_PAD_TABLES_H

#include "table.h"

enum { MAX_PAD_TABLES = 4096 };

/// The number of the table of such a pad: from memory, from the user's cache folder ($XDG_CACHE_HOME/whirl, or
/// ~/.cache/whirl) where it is whole, else it is made, which takes seconds, and left there. Errors as pad_table_new,
/// and WHIRL_BAD_INPUT for more tables than MAX_PAD_TABLES.
whirl_status pad_table_find(double arc, double ratio, cavitation law, double *number);

/// The table of a number that pad_table_find has given.
const pad_table *pad_table_of(double number);

#endif
