/// The oil of a bearing by itself: its viscosity, and what makes it warm.
#ifndef CASE_BEARING_OIL_H
#define CASE_BEARING_OIL_H

#include "settings.h"
#include "whirl/engine/bearing_table.h"

/// Reads what a file says of it; problems where that is not complete, or said twice.
void bearing_oil_read(case_reader *reader, const setting_list *file, whirl_bearing *out);

#endif
