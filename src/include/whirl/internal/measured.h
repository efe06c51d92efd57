/// Tables of measured numbers for the machine of a case, outside of a fit: the same columns, units and messages.
#ifndef WHIRL_MEASURED_H
#define WHIRL_MEASURED_H

#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/engine/fit.h"
#include "whirl/internal/csv.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A table of measured numbers.
typedef struct whirl_measured_table {
    const char *title; ///< first comment of the table, or ""
    /// Motions and their numbers, without unknowns. Instants are not folded into one revolution, and orders are any.
    whirl_fit fit;
} whirl_measured_table;

/// Reads the bytes of a table of comma-separated values, or of an HDF5, MAT or universal file; `name` is the file's in
/// messages. chosen [count]: columns that are read; all if `count` is 0. WHIRL_BAD_INPUT with the place of the error,
/// as a fit reports it; WHIRL_NO_MEMORY. Freed by whirl_measured_free. The case must outlive it.
whirl_status whirl_measured_read(const whirl_case *object, const char *name, const void *bytes, size_t size,
                                 const csv_chosen *chosen, size_t count, whirl_measured_table **out);

/// Frees a table; accepts NULL.
void whirl_measured_free(whirl_measured_table *measured);

#ifdef __cplusplus
}
#endif
#endif
