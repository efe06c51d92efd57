/// Modes followed from point to point along a parameter, each with a name.
#ifndef REPORT_MODE_LINES_H
#define REPORT_MODE_LINES_H

#include "whirl/engine/result.h"

/// Name of a line of modes, "2F": the second forward one by frequency at its last point; B: backward, M: mixed, to and
/// fro; T: torsional. Lines that reach the last point count first. Overdamped modes have no name and no line.
enum { MODE_NAME = 24 };

typedef struct mode_lines {
    size_t count, modes;      ///< lines, and modes of a point
    size_t *line;             ///< [points][modes] line of each mode; SIZE_MAX: none
    char (*names)[MODE_NAME]; ///< [count]
} mode_lines;

/// mode_lines_of: follows the modes of a table; free with mode_lines_free. Returns false, with nothing to free, if
/// modes were not followed, and without memory.
bool mode_lines_of(const whirl_table *table, mode_lines *out);
void mode_lines_free(mode_lines *lines);

/// Returns the name of a mode at a point; "" if it is on no line.
const char *mode_lines_name(const mode_lines *lines, size_t point, size_t mode);

#endif
