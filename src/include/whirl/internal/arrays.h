/// Arrays of numbers in measured files: HDF5 (also whirl's own results), MAT files before version 7.3, and universal
/// files (datasets 58 and 58b). Variables and records are called datasets here.
#ifndef WHIRL_ARRAYS_H
#define WHIRL_ARRAYS_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { ARRAYS_MAX_RANK = 8, ARRAYS_TEXT = 256 };

/// An open file.
typedef struct arrays_file arrays_file;

/// A dataset. Its numbers are `factor` of its unit each.
typedef struct arrays_item {
    int rank; ///< 0: a single number
    size_t sizes[ARRAYS_MAX_RANK];
    bool numbers;           ///< false: its values are no real numbers
    const char *described;  ///< its values, in messages: "texts"; static
    char unit[ARRAYS_TEXT]; ///< its attribute `unit` or `units` (MAT files: a text `x_unit`); "" without one
    double factor;          ///< 1, but for whirl's own numbers in scales of a case
} arrays_item;

/// Returns true for a file that begins as those of one of the formats do.
bool arrays_is_file(const char *path);

/// Does the same with the bytes of a file.
bool arrays_is_bytes(const void *bytes, size_t size);

/// Returns true for such a file that can be opened and is no result of whirl.
bool arrays_is_foreign(const char *path);

/// Opens a file. WHIRL_BAD_INPUT with a sentence for one of another format, damaged or cut off; WHIRL_IO_ERROR,
/// WHIRL_NO_MEMORY.
whirl_status arrays_open(const char *path, arrays_file **out);

/// Does the same with the bytes of a file, which must outlive it. `name` stands in messages.
whirl_status arrays_open_bytes(const void *bytes, size_t size, const char *name, arrays_file **out);

/// Closes a file; accepts NULL.
void arrays_close(arrays_file *file);

/// Finds a dataset by its path, "run/x". WHIRL_BAD_INPUT with the nearest name if there is none.
whirl_status arrays_find(arrays_file *file, const char *name, arrays_item *out);

/// Hands over all datasets with their paths, up to 10,000: sorted in HDF5 files, in the order of others.
typedef whirl_status (*arrays_visitor)(void *context, const char *name, const arrays_item *item);
whirl_status arrays_visit(arrays_file *file, arrays_visitor visit, void *context);

/// Reads a part of a dataset, count[i] numbers from first[i] on in each dimension, the last one fastest, as they are in
/// the file. WHIRL_BAD_INPUT if it has no such part, or values that are no numbers.
whirl_status arrays_read(arrays_file *file, const char *name, const size_t *first, const size_t *count, double *out);

/// Reads an attribute of an object ("/": the root) as a text; "" if it has none, or no text.
whirl_status arrays_text(arrays_file *file, const char *object, const char *attribute, char *text, size_t size);

/// Reads an attribute that is a number; NaN if there is none.
whirl_status arrays_number(arrays_file *file, const char *object, const char *attribute, double *out);

#ifdef __cplusplus
}
#endif
#endif
