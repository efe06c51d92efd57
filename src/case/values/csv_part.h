/// Headings of tables.
#ifndef CASE_CSV_PART_H
#define CASE_CSV_PART_H

#include "whirl/internal/csv.h"

/// Parts a heading into its name and the unit in brackets, which it takes from `text`.
void csv_part(csv_column *own, char text[CSV_TEXT]);

#endif
