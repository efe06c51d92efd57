/// Lines of modes: modes that were followed from point to point along a parameter, each line with a name.
#ifndef REPORT_MODE_LINES_H
#define REPORT_MODE_LINES_H

#include "whirl/engine/result.h"

/// Bytes of a line's name. "2F" is the second forward line, B: backward, M: to and fro (mixed), T: torsional, A: axial.
/// Lines are numbered by the frequency at their last points; those that reach the last point of the table come first.
/// Overdamped modes are on no line.
enum { MODE_NAME = 24 };

/// Ways of modes: backward, to and fro and forward as units_way returns them for lateral modes, and two more.
enum { MODE_BACKWARD = -1, MODE_TO_AND_FRO, MODE_FORWARD, MODE_TORSIONAL, MODE_AXIAL };

/// Returns the way of a mode at a point.
int mode_way(const whirl_table *table, size_t point, size_t mode);

/// Returns the name of a way: "backward", "axial".
const char *mode_way_name(int way);

typedef struct mode_lines {
    size_t count, modes;      ///< number of lines, and of modes of a point
    size_t *line;             ///< [points][modes] line of each mode; SIZE_MAX: none
    char (*names)[MODE_NAME]; ///< [count] names of the lines
} mode_lines;

/// mode_lines_of: follows the modes of a table; free with mode_lines_free. Returns false, with nothing to free, if
/// modes were not followed, and without memory.
bool mode_lines_of(const whirl_table *table, mode_lines *out);
void mode_lines_free(mode_lines *lines);

/// Returns the name of a mode at a point; "" if it is on no line.
const char *mode_lines_name(const mode_lines *lines, size_t point, size_t mode);

#endif
