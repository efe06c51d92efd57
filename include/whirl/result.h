/// Results: what a run found, with the case it came from and how it was computed; in memory and as a file.
#ifndef WHIRL_RESULT_H
#define WHIRL_RESULT_H

#include <stddef.h>
#include <stdio.h>

#include "whirl/analyze.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The points of one batch.
typedef struct whirl_table {
    char name[WHIRL_NAME_SIZE];      ///< "response", "sweep", "detail"
    char parameter[WHIRL_NAME_SIZE]; ///< what varies, or ""
    size_t count;
    double *values; ///< [count] of the parameter in SI (NaN when nothing varies)
    int *branch;    ///< [count] +1 carried from the first value on, -1 carried from the last, 0 not carried
    double *blocks; ///< [count][layout.size]
    whirl_layout layout;
    whirl_analysis_set analyses;
    whirl_integrate_options integrate;
    whirl_record_options record;
} whirl_table;

/// A named parameter of the case with the value that the run used, in SI.
typedef struct whirl_parameter {
    char name[WHIRL_NAME_SIZE];
    char unit[WHIRL_NAME_SIZE]; ///< SI unit, "1" for a plain number
    char text[128];             ///< as the case (or --set) gave it
    double value;
} whirl_parameter;

/// A fact about the run: version, git revision, compiler, flags, libraries, host, start, end, threads.
typedef struct whirl_fact {
    char name[WHIRL_NAME_SIZE];
    char value[256];
} whirl_fact;

typedef struct whirl_result {
    char title[256];
    char *case_text; ///< the case file, byte for byte; "" when there was none
    char case_name[256];
    double speed;        ///< rad/s
    double length_scale; ///< m per unit of length
    double force_scale;  ///< N per unit of force
    size_t parameter_count;
    whirl_parameter *parameters;
    size_t station_count;
    whirl_probe *stations; ///< names, state indices and bearing clearances (in length scales)
    size_t contact_count;
    char (*contacts)[WHIRL_NAME_SIZE]; ///< names
    size_t fact_count;
    whirl_fact *facts;
    size_t table_count;
    whirl_table *tables;
} whirl_result;

void whirl_result_free(whirl_result *result);

/// The table of that name, or NULL.
const whirl_table *whirl_result_table(const whirl_result *result, const char *name);

/// The numbers [rows][columns] of a field for a point and a station or contact (0 for fields of the point);
/// NULL when the table has no such field or an index is out of range. Borrowed.
const double *whirl_table_field(const whirl_table *table, size_t point, const char *field, size_t which);

/// The verdict on a point.
whirl_verdict whirl_table_verdict(const whirl_table *table, size_t point);

/// Appends a fact; a name that is there already gets the new value.
whirl_status whirl_result_add_fact(whirl_result *result, const char *name, const char *value);

/// Appends the facts of this build and host: version, revision, compiler, flags, libraries, host, processor,
/// instruction set.
whirl_status whirl_result_add_provenance(whirl_result *result);

/// Writes the result as an HDF5 file: to a temporary name beside `path`, synced, then renamed, so that no half
/// file is ever left. The layout of the file is described in docs/result-file.md.
whirl_status whirl_result_write(const whirl_result *result, const char *path);

/// Reads a file of whirl_result_write. WHIRL_BAD_INPUT with a sentence for a file that is not one.
whirl_status whirl_result_read(const char *path, whirl_result **result);

/// Writes every table as CSV files into the directory `path` (made when missing): one file with a line a point,
/// and one file a field that has rows. Units stand in the headings.
whirl_status whirl_result_export_csv(const whirl_result *result, const char *path);

/// Writes the points as one JSON document ({"points": [...]}) as the user guide describes.
whirl_status whirl_result_write_json(const whirl_result *result, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
