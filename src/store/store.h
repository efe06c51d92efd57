/// Files of results: bytes, shapes and items.
#ifndef STORE_STORE_H
#define STORE_STORE_H

#include "whirl/engine/result.h"
#include "whirl/engine/study.h"
#include "whirl/status.h"

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

// ---------------------------------------------------------------- atomic_file
// A file that appears whole or not at all: written under a temporary name in the same folder, synced, then renamed.

enum { ATOMIC_PATH_SIZE = 4096 };

typedef struct atomic_file {
    FILE *stream; ///< to write to, or by its descriptor; NULL when not open
    char path[ATOMIC_PATH_SIZE], temporary[ATOMIC_PATH_SIZE];
} atomic_file;

/// Opens the temporary file. WHIRL_IO_ERROR with path and reason: a folder of that name, no such parent folder, ...
whirl_status atomic_file_open(atomic_file *out, const char *path);

/// Gives the file its name when everything was written, removes it when not. Closes it in any case.
whirl_status atomic_file_commit(atomic_file *out);

/// Removes the temporary file.
void atomic_file_discard(atomic_file *out);

/// Returns true if anything of this name exists, even a dangling link.
bool atomic_file_there(const char *path);

/// Creates a folder and its missing parents; an existing one is fine.
whirl_status atomic_folder(const char *path);

// ---------------------------------------------------------------- bytes
// Bytes that are read at any place: a file's, or those of a block of memory.

typedef struct byte_source {
    /// Reads exactly `size` bytes that are there; 0, or an errno.
    int (*read)(void *context, uint64_t offset, void *to, size_t size);
    void *context;
    uint64_t size;
} byte_source;

/// A block of memory, which is borrowed.
byte_source bytes_of_memory(unsigned char *bytes, size_t size);

enum { BYTE_WINDOW = 1 << 16 };

/// An ordinary file opened for reading. WHIRL_IO_ERROR with path and reason. A window of it is buffered, since headers
/// are read in many small pieces.
typedef struct byte_file {
    int descriptor;
    byte_source source; ///< its context is this structure, which must not move
    uint64_t start;     ///< start of the window
    size_t length;
    unsigned char window[BYTE_WINDOW];
} byte_file;
whirl_status bytes_open(byte_file *file, const char *path);
void bytes_close(byte_file *file);

/// Read or write a range of bytes of an open file; interrupted calls are repeated. Return 0 or an errno.
int bytes_read_at(int descriptor, uint64_t offset, void *to, size_t size);
int bytes_write_at(int descriptor, uint64_t offset, const void *from, size_t size);

// ---------------------------------------------------------------- shape
// Shapes of datasets.

enum {
    SHAPE_AXES = 3,                 ///< dimensions of points: planes, rows, columns
    SHAPE_MAX_RANK = SHAPE_AXES + 3 ///< dimensions of a dataset: those, stations, rows, columns
};

/// Arrangement of values: a list, a matrix row by row, or planes of these.
typedef struct shape {
    int rank; ///< 1 to SHAPE_AXES
    size_t sizes[SHAPE_AXES];
} shape;

static inline shape list_of(size_t count) {
    return (shape){1, {count}};
}

static inline size_t shape_count(shape of) {
    size_t count = 1;
    for (int i = 0; i < of.rank; ++i) count *= of.sizes[i];
    return count;
}

// ---------------------------------------------------------------- format
// Names and bounds that writing and reading share. The layout of the file is described in docs/result-file.md.

#define FORMAT_NAME "whirl result"

enum {
    FORMAT_VERSION = 2, ///< version 1 had all points of a study, and a mark for finished ones
    FORMAT_MAX_TABLES = 64,
    FORMAT_MAX_FACTS = 1024,
    FORMAT_MAX_PARAMETERS = 100000,
    FORMAT_MAX_CASE_BYTES = 1 << 20,
    FORMAT_MAX_MEANING = 512, ///< bytes of a field's meaning with its end
    FORMAT_MAX_COLUMNS = 32,  ///< largest number of named columns
    FORMAT_MAX_ANALYSES = 32  ///< bits of a whirl_analysis_set
};

/// Values of a field's attribute "extent".
extern const char *const format_extents[3];

/// Groups of a file that are no tables.
bool format_reserved(const char *name);

/// Returns true for a name of letters, digits, '_', '-' and `slashes` slashes between them: 0 for tables, 1 for fields.
bool format_is_name(const char *name, int slashes);

/// Dimensions of the dataset of a field: [points][station or contact][rows][columns] without rows and columns that are
/// 1, or [points][rows][singles]; points of a whole map have two dimensions. Returns their number.
int format_dimensions(const whirl_field *field, shape points, size_t dimensions[SHAPE_MAX_RANK]);

/// Names of these dimensions ("point", "y", "x", "station", "row", ...), as many.
int format_dimension_names(const whirl_field *field, shape points, char names[SHAPE_MAX_RANK][WHIRL_NAME_SIZE]);

/// Names of a field's columns, two or more, if its meaning lists them: "x, y" or "x, y, vx, vy (remark)".
bool format_column_names(const whirl_field *field, char names[FORMAT_MAX_COLUMNS][WHIRL_NAME_SIZE]);

// ---------------------------------------------------------------- stored
// Generic walk over a result file: groups, datasets and attributes, whatever their names.

/// The values of a dataset or an attribute, in memory.
typedef struct stored_array {
    enum { STORED_NUMBERS, STORED_WHOLES, STORED_TEXTS } kind; ///< double, int64_t, texts of `width` bytes each
    int rank;                                                  ///< 0: a single value
    size_t sizes[SHAPE_MAX_RANK], count, width;                ///< the last dimension runs fastest; width of an element
    bool single;                                               ///< the file has the numbers in single precision
    void *values;
} stored_array;

/// Callbacks for members and attributes of a group or object; `object` is an open group or dataset.
typedef struct stored_visitor {
    void (*member)(whirl_status *status, void *context, const char *name, hid_t object);
    void (*attribute)(whirl_status *status, void *context, const char *name, const stored_array *array);
    void *context;
} stored_visitor;

/// Visits the members of a group by name (groups only), then the attributes of the object in their order. The first
/// error ends it; a visitor may leave out either function.
void stored_visit(whirl_status *status, hid_t object, const stored_visitor *visitor);

bool stored_is_group(hid_t object);

/// Finds the kind and shape of a dataset, no values. WHIRL_BAD_INPUT if the file lacks some of its numbers.
void stored_outline(whirl_status *status, hid_t dataset, stored_array *outline);

/// The same with the values, to be freed with stored_free.
void stored_read(whirl_status *status, hid_t dataset, stored_array *array);
void stored_free(stored_array *array);

/// Reads all texts and attributes of a result: those that are not needed otherwise (a verdict's name and reason follow
/// from numbers) may be damaged, too. WHIRL_BAD_INPUT.
void stored_check_texts(whirl_status *status, hid_t file);

/// Opens a result that has been read through before (see whirl_result_read_outline), calls `write` with its root, and
/// closes it.
typedef void (*stored_writer)(whirl_status *status, void *context, hid_t root);
whirl_status stored_open(const char *path, stored_writer write, void *context);

// ---------------------------------------------------------------- underway
// States of unfinished points: files JOURNAL-N next to the journal, one a thread, each replaced as a whole every few
// seconds.
//
// A state stays valid for its point, so nothing need be removed before the end: of several the furthest one counts.
// Frames are those of the journal; their payload begins with the revolutions that were done.

typedef struct underway underway;

/// Opens the states next to the journal at `path` for the study with that hash. States of an earlier run are read if
/// `resume`, else removed. NULL without memory.
underway *underway_open(const char *path, uint64_t identity, bool resume);

/// Reads the states next to another journal of the same study, too.
void underway_take(underway *states, const char *path);

/// Returns true if there are states next to the journal at `path`, of any study.
bool underway_any(const char *path);

/// Closes; the files stay, or are removed.
void underway_close(underway *states);
void underway_remove(underway *states);

/// See whirl_keeper.
void underway_save(underway *states, size_t worker, const whirl_point_state *kept, size_t count);
void *underway_saved(const underway *states, size_t batch, size_t slot, double *revolutions, size_t *size);

#endif
