// MAT files (version 5) of results.
#ifndef STORE_MAT_H
#define STORE_MAT_H

#include "whirl/status.h"

#include <stddef.h>

/// Writes the result like whirl_result_export_mat, whose `most` is the limit of MATLAB and Octave: the largest number
/// of bytes of a variable.
whirl_status mat_export(const char *result, const char *path, size_t most);

#endif
