/// Tables of numbers: text files with a line of headings, "de x [um]", then rows of numbers; or vectors of HDF5,
/// MAT and universal files, which are called HDF5 files here.
#ifndef WHIRL_CSV_H
#define WHIRL_CSV_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    CSV_TEXT = 96,
    CSV_VECTOR = 1 << 20 ///< csv_column.place of the first vector of an HDF5 file; places of others follow
};

/// A column.
typedef struct csv_column {
    char name[CSV_TEXT];   ///< heading without its unit: "de x"
    char unit[CSV_TEXT];   ///< text in brackets, or ""
    int place;             ///< column of its heading in its line, from 1; CSV_VECTOR and so on in HDF5 files
    char source[CSV_TEXT]; ///< HDF5: its dataset, "run/x"
} csv_column;

/// A table. Numbers are as written.
typedef struct csv_table {
    const char *path;       ///< in messages; borrowed
    bool vectors;           ///< the columns are vectors of an HDF5 file
    int heading;            ///< line of the headings, from 1; 0 in HDF5 files
    char title[256];        ///< first comment, or ""
    size_t column_count;    ///< number of columns
    csv_column *columns;    ///< [column_count]
    size_t count, capacity; ///< number of rows, and of those that fit
    double *numbers;        ///< [column_count][capacity]
    int *lines;             ///< [capacity] lines of the rows, from 1; HDF5: their numbers, from 1
} csv_table;

/// Reads a table with at most `most_columns` columns. Commas, semicolons or tabs separate cells. Blanks and quotes
/// around cells, empty lines and lines that begin with # are ignored. WHIRL_BAD_INPUT with the place of the error: more
/// or fewer cells than headings, empty cells, cells of more than 95 bytes, text for numbers; WHIRL_NO_MEMORY. Freed by
/// csv_free, after a failure, too.
whirl_status csv_read(const char *path, const char *text, size_t length, size_t most_columns, csv_table *out);

/// Does the same with a file of at most 1 GiB. In HDF5 files all vectors of numbers are columns: they have the names of
/// their datasets, and the unit of their attribute `unit` or `units`.
whirl_status csv_load(const char *path, size_t most_columns, csv_table *out);

/// Returns true for a name that ends as those of HDF5, MAT and universal files do, in letters of any size.
bool csv_is_measured(const char *name);

/// A column that is chosen from a file.
typedef struct csv_chosen {
    const char *heading; ///< "disc x [um]"; without a unit it is that of the file
    const char *dataset; ///< "run/x", or with indices, one of which is ':', "run/signals[:, 2]"; in text files a
                         ///< heading, with or without its unit, or "column 3", its number from 1
} csv_chosen;

/// Reads chosen columns of a file of either kind; all columns if `count` is 0. Errors as those of csv_load, and
/// WHIRL_BAD_INPUT for columns that the file does not have. Freed by csv_free, after a failure, too.
whirl_status csv_load_chosen(const char *path, const csv_chosen *chosen, size_t count, size_t most_columns,
                             csv_table *out);

/// Does the same with the bytes of a file.
whirl_status csv_read_chosen(const char *path, const void *bytes, size_t size, const csv_chosen *chosen, size_t count,
                             size_t most_columns, csv_table *out);

/// A column of a file that may be chosen.
typedef struct csv_listed {
    char name[CSV_TEXT]; ///< as csv_chosen.dataset
    char unit[CSV_TEXT]; ///< "" if it is not known
    size_t count;        ///< numbers in it
} csv_listed;

/// Lists the columns of the bytes of a file, with those of matrices one by one where there are at most 64. *out
/// [*count] is freed by the caller. Errors as those of csv_read_chosen.
whirl_status csv_list(const char *path, const void *bytes, size_t size, csv_listed **out, size_t *count);

/// Reads vectors of an HDF5 file as a table; `count` chosen ones, or if it is 0 all vectors. WHIRL_BAD_INPUT with a
/// sentence, WHIRL_IO_ERROR, WHIRL_NO_MEMORY. Freed by csv_free, after a failure, too.
whirl_status csv_load_vectors(const char *path, const csv_chosen *chosen, size_t count, size_t most_columns,
                              csv_table *out);

/// Does the same with the bytes of such a file.
whirl_status csv_read_vectors(const char *path, const void *bytes, size_t size, const csv_chosen *chosen, size_t count,
                              size_t most_columns, csv_table *out);

/// Lists the columns of the bytes of such a file, as csv_list.
whirl_status csv_list_vectors(const char *path, const void *bytes, size_t size, csv_listed **out, size_t *count);

/// Refuses a column whose heading has another unit than the file, `unit`; "": it is not known.
whirl_status csv_check_unit(const csv_table *table, size_t column, const char *unit);

/// Adds a column of `count` numbers, which are copied, to a table of vectors. All columns have as many.
whirl_status csv_add_vector(csv_table *table, const char *heading, const char *unit, const char *source,
                            const double *numbers, size_t count);

/// Frees a table; accepts an empty one.
void csv_free(csv_table *table);

/// Fails at a line and a column of the file, from 1; in HDF5 files at a vector, and at one of its numbers.
whirl_status csv_fail(const csv_table *table, int line, int column, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/// Finds the size in SI of a column's unit, which must be one of the dimension of `si`. WHIRL_BAD_INPUT if it is not,
/// or if it is missing; the sentence then gives `example`.
whirl_status csv_unit(const csv_table *table, size_t column, const char *si, const char *example, double *size);

/// Returns the numbers [count] of a column.
const double *csv_numbers(const csv_table *table, size_t column);

#ifdef __cplusplus
}
#endif
#endif
