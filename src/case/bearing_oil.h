/// Oil of a bearing file: its viscosity and its temperature.
#ifndef CASE_BEARING_OIL_H
#define CASE_BEARING_OIL_H

#include "parameters.h"
#include "settings.h"
#include "whirl/internal/bearing_table.h"

/// Reads the oil; reports incomplete and contradictory keys.
void bearing_oil_read(case_reader *reader, const setting_list *file, whirl_bearing *out);

#endif
