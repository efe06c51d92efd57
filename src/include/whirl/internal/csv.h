/// Tables of numbers in text files: a line of headings, "de x [um]", then rows of numbers.
#ifndef WHIRL_CSV_H
#define WHIRL_CSV_H

#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { CSV_TEXT = 96 };

/// A column.
typedef struct csv_column {
    char name[CSV_TEXT]; ///< heading without its unit: "de x"
    char unit[CSV_TEXT]; ///< text in brackets, or ""
    int place;           ///< column of its heading in its line, from 1
} csv_column;

/// A table. Numbers are as written.
typedef struct csv_table {
    const char *path;       ///< in messages; borrowed
    int heading;            ///< line of the headings, from 1
    char title[256];        ///< first comment, or ""
    size_t column_count;    ///< number of columns
    csv_column *columns;    ///< [column_count]
    size_t count, capacity; ///< number of rows, and of those that fit
    double *numbers;        ///< [column_count][capacity]
    int *lines;             ///< [capacity] lines of the rows, from 1
} csv_table;

/// Reads a table with at most `most_columns` columns. Commas, semicolons or tabs separate cells. Blanks and quotes
/// around cells, empty lines and lines that begin with # are ignored. WHIRL_BAD_INPUT with the place of the error: more
/// or fewer cells than headings, empty cells, cells of more than 95 bytes, text for numbers; WHIRL_NO_MEMORY. Freed by
/// csv_free, after a failure, too.
whirl_status csv_read(const char *path, const char *text, size_t length, size_t most_columns, csv_table *out);

/// Does the same with a file of at most 1 GiB.
whirl_status csv_load(const char *path, size_t most_columns, csv_table *out);

/// Frees a table; accepts an empty one.
void csv_free(csv_table *table);

/// Fails at a line and a column of the file, from 1.
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
