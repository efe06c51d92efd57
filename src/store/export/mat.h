// MAT files (version 5) of results.
#ifndef STORE_MAT_H
#define STORE_MAT_H

#include "whirl/status.h"

#include <stddef.h>

/// Writes the result as whirl_result_export_mat does, which gives as `most` what MATLAB and Octave read: no variable
/// may have more bytes.
whirl_status mat_export(const char *result, const char *path, size_t most);

#endif
