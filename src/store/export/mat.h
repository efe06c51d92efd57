// MAT files (version 5) of results.
#ifndef STORE_MAT_H
#define STORE_MAT_H

#include "whirl/status.h"

#include <stddef.h>

/// Writes a result file like whirl_result_export_mat, with `most` as the largest number of bytes of a variable.
whirl_status mat_export(const char *result, const char *path, size_t most);

#endif
