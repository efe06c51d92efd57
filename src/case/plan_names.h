/// Names in studies: stations of the machine, and parameters with values.
#ifndef CASE_PLAN_NAMES_H
#define CASE_PLAN_NAMES_H

#include "machine.h"
#include "plan_parts.h"

/// Reads one station, or several as a list, or as a text with blanks as in options of analyses.
void plan_read_stations(case_reader *reader, const machine_parts *machine, const setting_list *keys, const char *key,
                        bool several);

/// Returns the parameter that the key of a place names; NULL after a problem.
const parameter *plan_find_named(case_reader *reader, const file_node *where);

/// Refuses a parameter whose value is an expression; returns false then. Such a parameter cannot get another value.
bool plan_check_free(case_reader *reader, const file_node *where, const parameter *own);

/// Reads a value that a condition, or a change, gives to a parameter.
void plan_read_given(case_reader *reader, const file_node *where, condition_parts *condition);

/// Reads the key `change`: parameters with the values that they have after the change.
void plan_read_change(case_reader *reader, setting_list *keys, condition_parts *change);

#endif
