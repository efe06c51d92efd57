/// Handles for results: an interface of pointers, functions and plain numbers.
///
/// With whirl/job.h it serves programs that are not compiled against the other headers (Python, Julia, MATLAB, ...).
/// whirl_status is the only struct whose members these functions expose, so that all others may grow. Texts are UTF-8.
/// A returned pointer is borrowed from the handle passed in, and lives as long as that handle.
///
///     table = whirl_result_table(result, "sweep");
///     radius = whirl_table_column(table, whirl_table_field_index(table, "orbit/max_radius"), shape, &stride);
///
/// Stable interface: docs/abi.md says for how long.
#ifndef WHIRL_HANDLES_H
#define WHIRL_HANDLES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The result of a run (whirl/engine/result.h).
typedef struct whirl_result whirl_result;

/// The points of one part of a study.
typedef struct whirl_table whirl_table;

/// Storage for finished points outside of a run (whirl/engine/study.h, whirl/engine/journal.h).
typedef struct whirl_point_store whirl_point_store;

/// Reads a result file. WHIRL_BAD_INPUT with a sentence for a file of another kind.
whirl_status whirl_result_read(const char *path, whirl_result **result);

/// Reads all of a result file except the blocks of its points. Errors as whirl_result_read.
whirl_status whirl_result_read_outline(const char *path, whirl_result **outline);

/// Reads a measured record as a result: a table over the time, with commas, semicolons or tabs between values, or an
/// HDF5, MAT or universal file. The result is that of a study `runup`, whose rows, spectra and orbits are those of the
/// measured turns. Headings are `time [s]`; `keyphasor`, whose rising pulses are the mark, or `speed [rpm]`, whose
/// integral is the angle from the first sample on; and two probes a station by their directions, `de x [um]`, or
/// degrees from the x axis in the sense of rotation, `de 45 [mil]`. Lines that begin with # are comments, the first of
/// which is the title. WHIRL_BAD_INPUT names file, line and column. The turn before the second pulse is left out.
whirl_status whirl_result_read_record(const char *path, whirl_result **result);

/// Reads a measured record as whirl_result_read_record does, of which columns with the headings [count] are chosen by
/// their names [count] in the file, as in whirl_columns_read; all columns if `count` is 0. Errors likewise.
whirl_status whirl_result_read_record_columns(const char *path, const char *const *headings, const char *const *names,
                                              size_t count, whirl_result **result);

/// Columns of numbers of a measured file.
typedef struct whirl_columns whirl_columns;

/// Reads columns of a table of comma-separated values, or of an HDF5, MAT (version 4 to 7.3) or universal file
/// (datasets 58 and 58b). `count` columns with the headings [count] are chosen by their names [count] in the file: a
/// dataset or variable, "run/x", a part of one in which one index runs, "run/signals[:, 2]", a record of a universal
/// file, "record 2", or a heading of a table of comma-separated values, with or without its unit, or "column 3". With 0
/// all vectors are columns, under their own names and units. WHIRL_BAD_INPUT names the file, and what is wrong in it;
/// WHIRL_IO_ERROR if it cannot be read.
whirl_status whirl_columns_read(const char *path, const char *const *headings, const char *const *names, size_t count,
                                whirl_columns **columns);
size_t whirl_columns_count(const whirl_columns *columns);                        ///< Number of columns.
size_t whirl_columns_rows(const whirl_columns *columns);                         ///< Number of numbers of each column.
const char *whirl_columns_name(const whirl_columns *columns, size_t index);      ///< Heading without its unit.
const char *whirl_columns_unit(const whirl_columns *columns, size_t index);      ///< Unit, "" if it is not known.
const double *whirl_columns_numbers(const whirl_columns *columns, size_t index); ///< [rows], in the unit.

/// Frees columns; accepts NULL.
void whirl_columns_free(whirl_columns *columns);

/// Writes the result as an HDF5 file: to a temporary name in the folder of `path`, synced, then renamed, so that no
/// partly written file remains. Omits points that are not done. docs/result-file.md describes the layout.
whirl_status whirl_result_write(const whirl_result *result, const char *path);

/// Reads a result file back and compares all of it with the result, numbers bit for bit. WHIRL_IO_ERROR names the
/// difference.
whirl_status whirl_result_verify(const whirl_result *result, const char *path);

/// Frees a result and everything that belongs to it; accepts NULL.
void whirl_result_free(whirl_result *result);

/// Returns false for file names that suggest another format than a result: "a.csv", "a.txt", "a.yaml".
bool whirl_result_name_fits(const char *path);

/// Appends a fact, or replaces the value of the fact with that name.
whirl_status whirl_result_add_fact(whirl_result *result, const char *name, const char *value);

const char *whirl_result_title(const whirl_result *result);     ///< The title of the case, "" if it has none.
const char *whirl_result_case_name(const whirl_result *result); ///< The name of the case file.
const char *whirl_result_case_text(const whirl_result *result); ///< The case file, byte for byte.
double whirl_result_speed(const whirl_result *result);          ///< The speed of the shaft, rad/s.
double whirl_result_force_scale(const whirl_result *result);    ///< N per unit of force.
bool whirl_result_is_partial(const whirl_result *result);       ///< True if the run was stopped before its end.

/// Lists of a result.
typedef enum whirl_list {
    WHIRL_LIST_PARAMETERS = 0, ///< texts "unit" and "text", number "value" in SI
    WHIRL_LIST_STATIONS,       ///< numbers as whirl_probe_members names them ("clearance", "gap", "x", ...)
    WHIRL_LIST_CONTACTS,       ///< names only
    WHIRL_LIST_FACTS,          ///< text "value"
    WHIRL_LIST_TABLES          ///< names only; see whirl_result_table
} whirl_list;

size_t whirl_result_count(const whirl_result *result, whirl_list list); ///< Number of items of a list.

/// Returns the name of an item; NULL if the index is past the end.
const char *whirl_result_name(const whirl_result *result, whirl_list list, size_t index);

/// Returns a text of an item, by the names above; NULL if there is none.
const char *whirl_result_text(const whirl_result *result, whirl_list list, size_t index, const char *what);

/// Returns a number of an item, by the names above; NaN if there is none.
double whirl_result_number(const whirl_result *result, whirl_list list, size_t index, const char *what);

/// Chooses the units in which figures show the result, in the words of `units` in a case: "um, rpm, Hz, p-p". "" or
/// NULL resets the choice, also that of the case. WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_result_show_in(whirl_result *result, const char *units);

/// Returns the unit in which figures show a parameter, as its size in SI, and writes its name, at most `size` bytes (""
/// for plain numbers).
double whirl_result_shown_unit(const whirl_result *result, const char *parameter, char *name, size_t size);

/// Finds the value [count] of a parameter nearest to `text`: a number in SI, "628", or with any unit of the parameter,
/// "6000 rpm". Skips values that are not finite. WHIRL_BAD_INPUT with a sentence if `text` is not such a number, or
/// lies beyond all values by more than the last step there (for a single value: 1 %).
whirl_status whirl_nearest_value(const whirl_result *result, const char *parameter, const double *values, size_t count,
                                 const char *text, size_t *index);

/// Returns the factor by which figures multiply lengths in the scale of the case, and writes the name of the resulting
/// unit, at most `size` bytes. Sets `*over` if the name is the symbol of a length that divides them ("x / c").
double whirl_result_shown_length(const whirl_result *result, char *name, size_t size, bool *over);

/// Returns the further factor for amplitudes, which results hold zero to peak, and writes how they are counted ("p-p";
/// "0-p" by default).
double whirl_result_shown_amplitude(const whirl_result *result, char *name, size_t size);

/// Returns the unit of frequencies in Hz, and writes its name; 0 and "" for orders of the running speed.
double whirl_result_shown_frequency(const whirl_result *result, char *name, size_t size);

/// Returns the table of that name, or NULL.
const whirl_table *whirl_result_table(const whirl_result *result, const char *name);

const char *whirl_table_name(const whirl_table *table);      ///< "sweep", "map", ...
const char *whirl_table_parameter(const whirl_table *table); ///< The varied parameter, or "".
const char *whirl_table_varied(const whirl_table *table); ///< The second varied parameter, of a map or curves, or "".
/// Returns the third varied parameter, from plane to plane of a map, or "" if there is none.
const char *whirl_table_stacked(const whirl_table *table);
/// Returns the role of the table's points in the study, independent of its name: "point", "survey", "detail", "map",
/// "basin", "branches", "curves", "tori", "motions", "rest", "tolerances" or "records".
const char *whirl_table_role(const whirl_table *table);

size_t whirl_table_points(const whirl_table *table); ///< Number of points, done or not (whirl_table_done).

/// Returns true if the point is done. Only results of stopped runs, while in memory, have points that are not; files
/// contain only points that are done.
bool whirl_table_done(const whirl_table *table, size_t point);

/// Returns the index of a point in its study: the index itself, except in a partial result that was read from a file.
size_t whirl_table_slot(const whirl_table *table, size_t point);

/// Returns the number of parameter values of the study (for a map: of combinations). Each has one point, or one for
/// each of several starts. For a refined map: all of its grid, computed or not.
size_t whirl_table_places(const whirl_table *table);

/// Returns the rate, rad/s, of the phase whose turns are revolutions at a point: sections are taken once in each, and
/// orders are multiples of it. NaN if the rate varies between points and is not recorded.
double whirl_table_clock(const whirl_result *result, const whirl_table *table, size_t point);

/// Returns the index of the point's parameter value, from 0, in the order of values; of a map row by row, plane by
/// plane.
size_t whirl_table_place(const whirl_table *table, size_t point);

/// Returns the number of points of a row of a map whose grid is complete and stored row by row; else 0.
size_t whirl_table_row(const whirl_table *table);

/// Returns the number of points of a map's grid, in a refined map computed or not; for other tables the number of
/// points of the study.
size_t whirl_table_grid(const whirl_table *table);

/// Returns the number of rows in each plane of a map; 0 for other tables.
size_t whirl_table_rows(const whirl_table *table);

/// Returns the number of planes of a map, 1 if it has no third parameter; 0 for other tables. Points are stored row by
/// row, plane by plane.
size_t whirl_table_planes(const whirl_table *table);

/// Returns the parameter at each point [whirl_table_points] in SI, NaN if nothing varies.
const double *whirl_table_values(const whirl_table *table);

/// Returns the second parameter at a point of a map or of curves, in SI; NaN if there is none.
double whirl_table_second(const whirl_table *table, size_t point);

/// Returns the third parameter at a point of a map with planes, in SI; NaN if there is none.
double whirl_table_third(const whirl_table *table, size_t point);

/// Returns the length scale of a point, m per unit of length; that of the result if `table` is NULL.
double whirl_result_length_scale(const whirl_result *result, const whirl_table *table, size_t point);

/// Returns the branch of each point [whirl_table_points]: +1 carried from the first value on, -1 from the last, 0 not
/// carried.
const int *whirl_table_branch(const whirl_table *table);

size_t whirl_table_field_count(const whirl_table *table); ///< Number of fields of a point.

/// Returns the index of the field of that name; whirl_table_field_count if there is none.
size_t whirl_table_field_index(const whirl_table *table, const char *name);

const char *whirl_table_field_name(const whirl_table *table, size_t field);    ///< "orbit/max_radius"
const char *whirl_table_field_unit(const whirl_table *table, size_t field);    ///< In the notation of whirl_field.
const char *whirl_table_field_meaning(const whirl_table *table, size_t field); ///< One line.
const char *whirl_table_field_extent(const whirl_table *table, size_t field);  ///< "point", "station" or "contact"

/// Returns the numbers of a row in single precision, two in place of each column (signals of data sets); 0 for
/// fields in double precision.
size_t whirl_table_field_singles(const whirl_table *table, size_t field);

/// Returns true if fields of that name have rows, whatever number of rows the options give (a single row is an array,
/// too). False for unknown names.
bool whirl_field_has_rows(const char *name);

/// Returns the size in SI of one unit of a field, and writes the SI unit's name, at most `size` bytes ("m"). NaN for
/// lengths if the parameter changes the length scale (whirl_result_length_scale).
double whirl_table_field_si(const whirl_result *result, const whirl_table *table, size_t field, char *name,
                            size_t size);

/// Returns the numbers of a field at all points. The numbers of one point are contiguous, `shape` = {stations or
/// contacts (1: of the point), rows, columns}; those of the next point follow `stride` doubles later. NULL if the
/// table's blocks are not in memory (whirl_table_copy), as in an outline.
const double *whirl_table_column(const whirl_table *table, size_t field, size_t shape[3], size_t *stride);

/// Copies a field at all points into numbers [points][shape]. WHIRL_IO_ERROR if a block is lost.
whirl_status whirl_table_copy(const whirl_table *table, size_t field, double *numbers);

/// Writes the verdict on a point ("P-2") and its reason, each at most `size` bytes; both "" if the table has none.
void whirl_table_words(const whirl_table *table, size_t point, char *name, char *reason, size_t size);

/// Finds the attractor of each point of a basin, or of a table with several starts for each parameter value: its
/// number, from 1 for the attractor of most starts (0: not done, or without a verdict); the share of starts of the
/// basin or value that lead to it (NaN: not reported); and the standard error of that share for starts drawn at random.
/// Each array is [whirl_table_points], or NULL if not wanted. 0 and NaN at all points of other tables. WHIRL_NO_MEMORY.
whirl_status whirl_table_attractor_numbers(const whirl_table *table, size_t *numbers, double *shares, double *errors);

/// Returns the name of an option of the table's integration or record, by index from 0, and writes its value ("dop853",
/// "1e-9"). NULL past the last.
const char *whirl_table_option(const whirl_table *table, size_t index, char *text, size_t size);

/// Builds a figure of a result by its name (NULL: the first) as the JSON document of docs/figures.md. `units` as in
/// reports, `panels` ("x,exponent") and logarithmic axes `log` ("x", "y", "xy"); NULL each for the default. *json is
/// freed by whirl_text_free. WHIRL_BAD_INPUT with a sentence for an unknown figure, panel or unit.
whirl_status whirl_result_figure(const whirl_result *result, const char *name, const char *units, const char *panels,
                                 const char *log, char **json);

/// Answers a balancing file as `whirl balance` does (docs/guide/14-balancing.md), as a JSON document. `name` is the
/// file's name in messages; the model is searched for in its folder. Writes every problem of the file or its model to
/// `problems` as whirl_case_check does. Findings are in `units`, or (NULL) those of the file. *json is freed by
/// whirl_text_free.
whirl_status whirl_balance_json(const char *text, size_t length, const char *name, const char *units, char *problems,
                                size_t size, char **json);

/// Does the same as whirl_result_figure, and draws the figure of a second result into it, dashed: a measured record
/// over a model. WHIRL_BAD_INPUT also if both cannot lie in one picture.
whirl_status whirl_result_figure_with(const whirl_result *result, const whirl_result *with, const char *name,
                                      const char *units, const char *panels, const char *log, char **json);

/// Lists the figures of a result, one line each: name, tab, title. *lines is freed by whirl_text_free.
whirl_status whirl_result_figures(const whirl_result *result, const char *units, char **lines);

/// Writes findings on machines at rest, branches, tori and spectra (docs/result-file.md, "Findings as JSON"): the sheet
/// `sheet` ("peaks", or "TABLE/peaks" if several tables have one), or, if NULL, all statements and sheets. `units` as
/// in reports, or NULL; `format` is "text" or "json", for a sheet also "csv", "latex" or "markdown". *text is freed by
/// whirl_text_free. WHIRL_BAD_INPUT with a sentence for an unknown sheet, unit or format.
whirl_status whirl_result_findings(const whirl_result *result, const char *sheet, const char *units, const char *format,
                                   char **text);

/// Lists the sheets of a result, one line each: name for whirl_result_findings, tab, title. *lines is freed by
/// whirl_text_free.
whirl_status whirl_result_sheets(const whirl_result *result, const char *units, char **lines);

/// Writes the warnings of a result (whirl_result_warning), one a line, with their numbers in units as in reports; NULL:
/// those of the case. *lines is freed by whirl_text_free. WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_result_warnings(const whirl_result *result, const char *units, char **lines);

void whirl_text_free(char *text); ///< Frees a text returned by these functions; accepts NULL.

/// Answers a bearing file as `whirl bearing` does (docs/guide/15-bearings.md), as a JSON document, and writes its
/// figures (curves, sommerfeld, locus) as a list of the documents of docs/figures.md; figures NULL: not wanted. `name`
/// is the file's name in messages; findings, warnings and figures are in `units`, or (NULL) those of the file; threads
/// 0: one per core. Writes every problem of the file to `problems` as whirl_case_check does. *json and *figures are
/// freed by whirl_text_free.
whirl_status whirl_bearing_json(const char *text, size_t length, const char *name, const char *units, int threads,
                                char *problems, size_t size, char **json, char **figures);

/// Writes the table of a data set's records as CSV (`what` is "index"), or its data sheet as Markdown ("datasheet"), as
/// `whirl run` writes them next to the result. `name`: name of the files without their extensions. *text is freed by
/// whirl_text_free. WHIRL_BAD_INPUT with a sentence for a result of another study, and for another word.
whirl_status whirl_result_dataset(const whirl_result *result, const char *what, const char *name, char **text);

/// Reads the size of the signals of a data set's file: [record][channel][sample]. WHIRL_IO_ERROR; WHIRL_BAD_INPUT for
/// other files.
whirl_status whirl_signals_shape(const char *path, size_t sizes[3]);

/// Reads the signals of `count` records from row `first`, from 0, on: out [count][channels][samples]. Errors as
/// whirl_signals_shape; WHIRL_BAD_INPUT for rows that the file does not have.
whirl_status whirl_signals_read(const char *path, size_t first, size_t count, float *out);

#ifdef __cplusplus
}
#endif
#endif
