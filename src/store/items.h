// Named values in an HDF5 file: attributes and datasets of texts, doubles and whole numbers.
//
// Every call takes a status, which keeps the first failure; calls after a failure do nothing. So callers need no
// checks, and read like a list of the file's contents.
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

/// Write an attribute of an object: a text, a list of texts, a double, or a whole number (int64_t).
void put_text_attribute(whirl_status *status, hid_t object, const char *name, const char *text);
void put_texts_attribute(whirl_status *status, hid_t object, const char *name, texts list);
void put_number_attribute(whirl_status *status, hid_t object, const char *name, double value);
void put_whole_attribute(whirl_status *status, hid_t object, const char *name, int64_t value);

/// Makes a group whose attributes keep their order; to be closed with close_group.
hid_t put_group(whirl_status *status, hid_t parent, const char *name);
void close_group(hid_t group);

/// Write a dataset [count], [rows][columns] or [planes][rows][columns], chunked and with Fletcher32 checksums. A count
/// of 0 is allowed. The attribute "unit" has the unit of numbers, and "1" for whole numbers.
void put_texts(whirl_status *status, hid_t parent, const char *name, texts list);
void put_wholes(whirl_status *status, hid_t parent, const char *name, const int64_t *values, shape of);
void put_numbers(whirl_status *status, hid_t parent, const char *name, const double *values, shape of,
                 const char *unit);

void close_dataset(hid_t dataset);

/// A dataset that is written or read point by point, with one chunk at a time in memory: [points][...] or, for points
/// of a map, [planes][rows][columns][...].
typedef struct column {
    hid_t dataset, type; ///< type: that of the values in memory
    int rank;
    hsize_t dimensions[SHAPE_MAX_RANK];
    int axes;                    ///< number of leading dimensions, those of the points
    int divided;                 ///< last of these dimensions along which a chunk is shorter than the dataset
    size_t size;                 ///< bytes of a point
    size_t most, gathered, done; ///< numbers of points: of a chunk, in the buffer, transferred before
    unsigned char *buffer;
} column;

/// Begin a dataset of doubles; of floats (`singles`, whose name is "group/name" and whose group is made); of whole
/// numbers (int64_t), one a point; or of texts of at most `size` bytes, zero bytes included. Its first dimensions are
/// those of the points. Attributes can be added until column_end, which must be called after a failure, too.
void column_of_numbers(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                       const size_t *dimensions, int rank, const char *unit);
void column_of_singles(whirl_status *status, column *out, hid_t parent, const char *name, shape points,
                       const size_t *dimensions, int rank, const char *unit);
void column_of_wholes(whirl_status *status, column *out, hid_t parent, const char *name, shape points);
void column_of_texts(whirl_status *status, column *out, hid_t parent, const char *name, shape points, size_t size);

/// Appends the values of the next point.
void column_put(whirl_status *status, column *out, const void *point);
void column_end(whirl_status *status, column *out);

// ---------------------------------------------------------------- reading (get.c)
//
// Kind, rank and size must be the expected ones, which is checked before values are read. A dataset must be stored as
// put.c does, so that a small file cannot claim to have a large dataset. Links to other places and files are refused.

/// Reads a text of at most `size` bytes, zero byte included; longer texts are refused.
void get_text_attribute(whirl_status *status, hid_t object, const char *name, char *text, size_t size);
void get_number_attribute(whirl_status *status, hid_t object, const char *name, double *value);
int64_t get_whole_attribute(whirl_status *status, hid_t object, const char *name, int64_t low, int64_t high);

/// Reads at most `most` texts of at most `stride` bytes, zero bytes included; returns their number.
size_t get_texts_attribute(whirl_status *status, hid_t object, const char *name, char *first, size_t stride,
                           size_t most);

/// Return the number of attributes of an object (at most `most`), and the name of one, in the order of writing.
size_t get_attribute_count(whirl_status *status, hid_t object, size_t most);
void get_attribute_name(whirl_status *status, hid_t object, size_t index, char *name, size_t size);

/// Open a group or a dataset by its path below `parent`; negative on failure. The caller closes it (close_group,
/// close_dataset).
hid_t get_group(whirl_status *status, hid_t parent, const char *name);
hid_t get_dataset(whirl_status *status, hid_t parent, const char *name);

/// Returns the shape of a dataset of at most `most` values; that of an empty list on failure.
shape get_shape(whirl_status *status, hid_t parent, const char *name, size_t most);

/// Returns the length of a one-dimensional dataset, at most `most`.
size_t get_length(whirl_status *status, hid_t parent, const char *name, size_t most);

/// Read all values of a dataset [count] or, for numbers, of any shape. Texts have at most `size` bytes, zero byte
/// included, and are written `stride` bytes apart.
void get_texts(whirl_status *status, hid_t parent, const char *name, char *first, size_t size, size_t stride,
               size_t count);
void get_wholes(whirl_status *status, hid_t parent, const char *name, int64_t *values, shape of);
void get_numbers(whirl_status *status, hid_t parent, const char *name, double *values, shape of);

/// Open a dataset of doubles, of floats, or of whole numbers (int64_t, one a point) that has exactly these dimensions,
/// to be read point by point. column_close must be called after a failure, too.
void column_open(whirl_status *status, column *from, hid_t parent, const char *name, shape points,
                 const size_t *dimensions, int rank);
void column_open_singles(whirl_status *status, column *from, hid_t parent, const char *name, shape points,
                         const size_t *dimensions, int rank);
void column_open_wholes(whirl_status *status, column *from, hid_t parent, const char *name, shape points);

/// Reads the numbers of the next point.
void column_get(whirl_status *status, column *from, void *numbers);
void column_close(column *from);

/// Returns the only text of a dataset, of at most `most` bytes without its zero byte; to be freed.
char *get_long_text(whirl_status *status, hid_t parent, const char *name, size_t most);

// ---------------------------------------------------------------- both (format.c)

/// Sets the dimensions of a column, and the bytes of a point; a value has `element` bytes.
void column_lay(column *of, shape points, const size_t *dimensions, int rank, size_t element);

/// Allocates a buffer for the points of one chunk; false without memory. A chunk that has a part of a row has points of
/// one row alone; the same holds for planes.
bool column_buffer(column *of, const hsize_t *chunk);

/// Returns the number of points to transfer at a time from `done` on: those of a chunk, or those that remain of the row
/// or plane that chunks divide.
size_t column_next_count(const column *of);

/// Writes the hyperslab of `points` points of the dataset from `done` on.
void column_box(const column *of, size_t points, hsize_t *first, hsize_t *count);

#endif
