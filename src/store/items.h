// Named values in an HDF5 file: attributes and datasets of texts, doubles and whole numbers.
//
// The first failure is kept in the status that every call takes, and later calls then do nothing: the callers read as
// the list of what a file holds.
#ifndef STORE_ITEMS_H
#define STORE_ITEMS_H

#include "shape.h"
#include "whirl/status.h"

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Texts `stride` bytes apart, each with its zero byte.
typedef struct texts {
    const char *first;
    size_t stride, count;
} texts;

// ---------------------------------------------------------------- writing (put.c)

void put_text_attribute(whirl_status *status, hid_t object, const char *name, const char *text);
void put_texts_attribute(whirl_status *status, hid_t object, const char *name, texts list);
void put_number_attribute(whirl_status *status, hid_t object, const char *name, double value);
void put_whole_attribute(whirl_status *status, hid_t object, const char *name, int64_t value);

/// put_group: makes a group whose attributes keep their order; close it with close_group.
hid_t put_group(whirl_status *status, hid_t parent, const char *name);
void close_group(hid_t group);

/// Datasets [count], [rows][columns] or [planes][rows][columns], chunked and with Fletcher32 checksums. A count of 0 is
/// allowed. Numbers have their unit in an attribute, whole numbers 1.
void put_texts(whirl_status *status, hid_t parent, const char *name, texts list);
void put_wholes(whirl_status *status, hid_t parent, const char *name, const int64_t *values, shape of);
void put_numbers(whirl_status *status, hid_t parent, const char *name, const double *values, shape of,
                 const char *unit);

void close_dataset(hid_t dataset);

/// A dataset [points][...] or, of points of a map, [planes][rows][columns][...] that is written, or read, one point
/// after the other: a chunk at a time is in memory.
typedef struct column {
    hid_t dataset, type; ///< the type in memory
    int rank;
    hsize_t dimensions[SHAPE_MAX_RANK];
    int axes;                    ///< dimensions of the points
    int divided;                 ///< the last of them of which a chunk has not all
    size_t size;                 ///< bytes of a point
    size_t most, gathered, done; ///< points: of a chunk, in the buffer, and before it
    unsigned char *buffer;
} column;

/// Begin a dataset of doubles, or of floats for `singles` (whose group, "group/name", is made), of whole numbers
/// (int64_t), one a point, or of texts of at most `size` bytes with their zero bytes. Its first dimensions are those of
/// the points. It is open for attributes until column_end, which must be called after a failure, too.
void column_of_numbers(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                       const size_t *dimensions, int rank, const char *unit);
void column_of_singles(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                       const size_t *dimensions, int rank, const char *unit);
void column_of_wholes(whirl_status *status, column *out, hid_t parent, const char *name, shape points);
void column_of_texts(whirl_status *status, column *out, hid_t parent, const char *name, shape points, size_t size);

/// Appends a point.
void column_put(whirl_status *status, column *out, const void *point);
void column_end(whirl_status *status, column *out);

// ---------------------------------------------------------------- reading (get.c)
//
// Kind, rank and size are checked against what is expected before anything is read; a dataset must be stored as those
// written here, so that a small file cannot claim a large one; links to other places and files are refused.

/// Writes at most `size` bytes, end included; longer texts are refused.
void get_text_attribute(whirl_status *status, hid_t object, const char *name, char *text, size_t size);
void get_number_attribute(whirl_status *status, hid_t object, const char *name, double *value);
int64_t get_whole_attribute(whirl_status *status, hid_t object, const char *name, int64_t low, int64_t high);

/// At most `most` texts of at most `stride` bytes with their ends; returns how many there are.
size_t get_texts_attribute(whirl_status *status, hid_t object, const char *name, char *first, size_t stride,
                           size_t most);

/// Attributes of an object (at most `most`), and the name of one in the order of writing.
size_t get_attribute_count(whirl_status *status, hid_t object, size_t most);
void get_attribute_name(whirl_status *status, hid_t object, size_t index, char *name, size_t size);

hid_t get_group(whirl_status *status, hid_t parent, const char *name);
hid_t get_dataset(whirl_status *status, hid_t parent, const char *name);

/// Shape of a dataset of at most `most` values; an empty list on failure.
shape get_shape(whirl_status *status, hid_t parent, const char *name, size_t most);

/// Length of a one-dimensional dataset, at most `most`.
size_t get_length(whirl_status *status, hid_t parent, const char *name, size_t most);

/// All values of datasets [count] or, of numbers, [rows][columns] and so on. Texts of at most `size` bytes, end
/// included, go to places `stride` bytes apart.
void get_texts(whirl_status *status, hid_t parent, const char *name, char *first, size_t size, size_t stride,
               size_t count);
void get_wholes(whirl_status *status, hid_t parent, const char *name, int64_t *values, shape of);
void get_numbers(whirl_status *status, hid_t parent, const char *name, double *values, shape of);

/// Opens a dataset of doubles that has exactly these dimensions, or of floats, or of whole numbers (int64_t), one a
/// point, to be read by points; column_close also after a failure.
void column_open(whirl_status *status, column *from, hid_t parent, const char *name, shape points,
                 const size_t *dimensions, int rank);
void column_open_singles(whirl_status *status, column *from, hid_t parent, const char *name, shape points,
                         const size_t *dimensions, int rank);
void column_open_wholes(whirl_status *status, column *from, hid_t parent, const char *name, shape points);

/// The next point's numbers.
void column_get(whirl_status *status, column *from, void *numbers);
void column_close(column *from);

/// The only text of a dataset, of at most `most` bytes without its end; to be freed.
char *get_long_text(whirl_status *status, hid_t parent, const char *name, size_t most);

// ---------------------------------------------------------------- both (column.c)

/// Sets the dimensions of a column, and the bytes of a point of `element` bytes a value.
void column_lay(column *of, shape points, const size_t *dimensions, int rank, size_t element);

/// Allocates a buffer for chunks of these dimensions; false without memory. A part of a row is alone in its chunk, and
/// so is a part of a plane.
bool column_buffer(column *of, const hsize_t *chunk);

/// Number of points to transfer at a time from `done` on: those of a chunk, or the rest of the row or plane that it
/// divides.
size_t column_room(const column *of);

/// The place of so many points in the dataset, from `done` on.
void column_box(const column *of, size_t points, hsize_t *first, hsize_t *count);

#endif
