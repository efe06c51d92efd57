/// A field of one number, added to a layout.
#ifndef STUDY_ADDED_FIELD_H
#define STUDY_ADDED_FIELD_H

#include "whirl/engine/analyze.h"

/// Adds a field of one number a point at the end of a layout, which has space. Strings other than the name must be
/// static.
void study_add_field(whirl_layout *layout, const char *name, const char *unit, const char *meaning);

#endif
