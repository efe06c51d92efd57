/// Visits the groups, datasets and attributes of a result file, whatever their names are.
#ifndef STORE_STORED_H
#define STORE_STORED_H

#include "shape.h"
#include "whirl/status.h"

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>

/// The values of a dataset or an attribute, in memory.
typedef struct stored_array {
    enum { STORED_NUMBERS, STORED_WHOLES, STORED_TEXTS } kind; ///< double, int64_t, texts of `width` bytes each
    int rank;                                                  ///< 0: a single value
    size_t sizes[SHAPE_MAX_RANK], count, width; ///< sizes: the last dimension runs fastest; width: bytes of an element
    bool single;                                ///< the file has the numbers in single precision
    void *values;
} stored_array;

/// Callbacks for members and attributes of a group or object; `object` is an open group or dataset.
typedef struct stored_visitor {
    void (*member)(whirl_status *status, void *context, const char *name, hid_t object);
    void (*attribute)(whirl_status *status, void *context, const char *name, const stored_array *array);
    void *context;
} stored_visitor;

/// Visits the members of a group, sorted by name (datasets have none), then the attributes of the object in their
/// order. The first error ends the visit. Either function may be NULL.
void stored_visit(whirl_status *status, hid_t object, const stored_visitor *visitor);

bool stored_is_group(hid_t object);

/// Finds the kind and shape of a dataset, without its values. WHIRL_BAD_INPUT if the file lacks some of its numbers.
void stored_outline(whirl_status *status, hid_t dataset, stored_array *outline);

/// Reads a dataset with its values, to be freed with stored_free.
void stored_read(whirl_status *status, hid_t dataset, stored_array *array);
void stored_free(stored_array *array);

/// Reads all datasets but the fields of tables, and all attributes, to find damage in data that no reader needs (names
/// of verdicts and shares of attractors follow from other numbers). WHIRL_BAD_INPUT if data are damaged.
void stored_check_unread(whirl_status *status, hid_t file);

/// Opens a result file, calls `write` with its root, and closes it. The file must have been read before
/// (whirl_result_read_outline).
typedef void (*stored_writer)(whirl_status *status, void *context, hid_t root);
whirl_status stored_open(const char *path, stored_writer write, void *context);

#endif
