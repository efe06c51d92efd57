/// Names and limits that writing and reading of result files share. docs/result-file.md describes the layout of the
/// file.
#ifndef STORE_FORMAT_H
#define STORE_FORMAT_H

#include "shape.h"
#include "whirl/engine/analyze.h"
#include "whirl/engine/descriptor.h"

#include <stdbool.h>
#include <stddef.h>

#define FORMAT_NAME "whirl result"

enum {
    FORMAT_VERSION = 2, ///< version 1 stored all points of a study, with a mark for finished ones
    FORMAT_MAX_TABLES = 64,
    FORMAT_MAX_FACTS = 1024,
    FORMAT_MAX_PARAMETERS = 100000,
    FORMAT_MAX_CASE_BYTES = 1 << 20,
    FORMAT_MAX_MEANING = 512, ///< bytes of a field's meaning, zero byte included
    FORMAT_MAX_ANALYSES = 32  ///< bits of a whirl_analysis_set
};

/// Values of a field's attribute "extent".
extern const char *const format_extents[3];

/// Returns true for names of groups of a file that are no tables.
bool format_reserved(const char *name);

/// Returns true for a name of letters, digits, '_', '-' and `slashes` slashes between them: 0 for tables, 1 for fields.
bool format_is_name(const char *name, int slashes);

/// Writes the dimensions of a field's dataset and returns their number: [points][station or contact][rows][columns]
/// without rows and columns that are 1, or for signals [points][rows][singles] (whirl_field.singles: one a sample).
/// The points of a whole map have two dimensions, y and x, or three with planes.
int format_dimensions(const whirl_field *field, shape points, size_t dimensions[SHAPE_MAX_RANK]);

/// Writes the names of these dimensions ("point", "y", "x", "station", "row", ...) and returns their number.
int format_dimension_names(const whirl_field *field, shape points, char names[SHAPE_MAX_RANK][WHIRL_NAME_SIZE]);

#endif
