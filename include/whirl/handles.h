/// Results through handles: pointers, functions and plain numbers alone.
///
/// For programs that are not compiled against the other headers (Python, Julia, MATLAB, ...), with whirl/job.h: no
/// struct of the library crosses these functions by its members but whirl_status, so that structs may grow. Texts are
/// UTF-8. What is returned by pointer is borrowed from the handle that it was asked of, and lives as long as that one.
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

/// What a run found (whirl/engine/result.h).
typedef struct whirl_result whirl_result;

/// The points of one part of a study, in a result.
typedef struct whirl_table whirl_table;

/// Where finished points are kept (whirl/engine/study.h, whirl/engine/journal.h).
typedef struct whirl_keeper whirl_keeper;

// ---------------------------------------------------------------- results

/// Reads a file of whirl_result_write. WHIRL_BAD_INPUT with a sentence for a file that is not one.
whirl_status whirl_result_read(const char *path, whirl_result **result);

/// Reads all of a file but the numbers of its points, whose tables then have no blocks. Errors as whirl_result_read.
whirl_status whirl_result_read_outline(const char *path, whirl_result **outline);

/// Writes the result as an HDF5 file: to a temporary name beside `path`, synced, then renamed, so that no half
/// file is ever left. Points that are not done are left out. The layout of the file is described in
/// docs/result-file.md.
whirl_status whirl_result_write(const whirl_result *result, const char *path);

/// Reads a file of whirl_result_write back and compares all of it with the result, numbers bit for bit. WHIRL_IO_ERROR
/// that names what differs.
whirl_status whirl_result_verify(const whirl_result *result, const char *path);

/// Frees a result and all that belongs to it; NULL is none.
void whirl_result_free(whirl_result *result);

/// Returns false for names of files that would pass for something else than a result: "a.csv", "a.txt", "a.yaml".
bool whirl_result_name_fits(const char *path);

/// Appends a fact; a name that is there already gets the new value.
whirl_status whirl_result_add_fact(whirl_result *result, const char *name, const char *value);

const char *whirl_result_title(const whirl_result *result);     ///< The title of the case, "" where it has none.
const char *whirl_result_case_name(const whirl_result *result); ///< The name of the case file.
const char *whirl_result_case_text(const whirl_result *result); ///< The case file, byte for byte.
double whirl_result_speed(const whirl_result *result);          ///< Of the shaft, rad/s.
double whirl_result_force_scale(const whirl_result *result);    ///< N per unit of force.
bool whirl_result_is_partial(const whirl_result *result);       ///< Whether the run was stopped before its end.

/// What a result has lists of.
typedef enum whirl_list {
    WHIRL_LIST_PARAMETERS = 0, ///< texts "unit" and "text", number "value" in SI
    WHIRL_LIST_STATIONS,       ///< numbers as whirl_probe_members names them ("clearance", "gap", "x", ...)
    WHIRL_LIST_CONTACTS,       ///< names alone
    WHIRL_LIST_FACTS,          ///< text "value"
    WHIRL_LIST_TABLES          ///< names alone; see whirl_result_table
} whirl_list;

size_t whirl_result_count(const whirl_result *result, whirl_list list); ///< Items of a list.

/// The name of an item; NULL where there is none of that index.
const char *whirl_result_name(const whirl_result *result, whirl_list list, size_t index);

/// A text of an item, by the names above; NULL where there is none.
const char *whirl_result_text(const whirl_result *result, whirl_list list, size_t index, const char *what);

/// A number of an item, by the names above; NaN where there is none.
double whirl_result_number(const whirl_result *result, whirl_list list, size_t index, const char *what);

/// Chooses the units in which figures show the result's numbers, in the words of `units` in a case: "um, rpm, Hz, p-p".
/// "" or NULL takes the choice back, also the case's own. WHIRL_BAD_INPUT for words that are no units.
whirl_status whirl_result_show_in(whirl_result *result, const char *units);

/// The unit in which figures show a parameter: its name, at most `size` bytes ("" of plain numbers); gives its size in
/// SI.
double whirl_result_shown_unit(const whirl_result *result, const char *parameter, char *name, size_t size);

/// Finds the value [count] of a parameter that is nearest to one that a person tells: a number in SI, "628", or with
/// any unit of the parameter, "6000 rpm"; values that are no numbers are left out. WHIRL_BAD_INPUT with a sentence
/// where `told` is no such number, or lies farther beyond all values than the last step there (of a lone value: 1 %).
whirl_status whirl_nearest_value(const whirl_result *result, const char *parameter, const double *values, size_t count,
                                 const char *told, size_t *index);

/// What lengths in the scale of the case are multiplied by in figures, and the name of the unit that makes them so, at
/// most `size` bytes. Sets `*over` where that is the symbol of a length which they are divided by ("x / c").
double whirl_result_shown_length(const whirl_result *result, char *name, size_t size, bool *over);

/// What amplitudes, which results hold zero to peak, are multiplied by besides, and how they are counted ("p-p", "0-p"
/// where nobody asked).
double whirl_result_shown_amplitude(const whirl_result *result, char *name, size_t size);

/// The unit of frequencies in Hz, and its name; 0 and "" for orders of the running speed.
double whirl_result_shown_frequency(const whirl_result *result, char *name, size_t size);

// ---------------------------------------------------------------- tables

/// The table of that name, or NULL.
const whirl_table *whirl_result_table(const whirl_result *result, const char *name);

const char *whirl_table_name(const whirl_table *table);      ///< "sweep", "map", ...
const char *whirl_table_parameter(const whirl_table *table); ///< What varies, or "".
const char *whirl_table_varied(const whirl_table *table);    ///< What varies besides, in a map or curves, or "".
const char *whirl_table_stacked(const whirl_table *table);   ///< What varies from plane to plane of a map, or "".

size_t whirl_table_points(const whirl_table *table); ///< Points, done or not (whirl_table_done).

/// Whether a point is done. Only the results of runs that were stopped have points that are not; a file has but those
/// that are.
bool whirl_table_done(const whirl_table *table, size_t point);

/// Which point of the study a point is: its own index, but in a result that was read and is partial.
size_t whirl_table_slot(const whirl_table *table, size_t point);

/// Places of the study in its parameters, which has one point, or one from each of several starts, at each; of a
/// refined map all of its grid, whether they are computed or not.
size_t whirl_table_places(const whirl_table *table);

/// rad/s of the phase by which sections are taken, at a point: revolutions are turns of it, and orders multiples of its
/// rate. NaN where that changes from point to point in a way that is not told.
double whirl_table_clock(const whirl_result *result, const whirl_table *table, size_t point);

/// The place of a point, from 0, in the order of the values: of a map row by row, plane by plane.
size_t whirl_table_place(const whirl_table *table, size_t point);

/// Points of a row of a map whose points all are there, row by row along the parameter, in one list; else 0.
size_t whirl_table_row(const whirl_table *table);

/// Points of the grid of a map: all of a refined one's, whether they are computed or not; of other tables the same as
/// the points that the study has.
size_t whirl_table_grid(const whirl_table *table);

/// Rows of the grid of a map, in each of its planes; 0 where a table is no map.
size_t whirl_table_rows(const whirl_table *table);

/// Planes of a map, 1 where it has no third parameter: its points follow each other row by row, plane by plane. 0 where
/// a table is no map.
size_t whirl_table_planes(const whirl_table *table);

/// [whirl_table_points] the parameter in SI, NaN where nothing varies.
const double *whirl_table_values(const whirl_table *table);

/// The value of the second parameter at a point of a map or of curves, in SI; NaN where there is none.
double whirl_table_second(const whirl_table *table, size_t point);

/// The value of the third parameter at a point of a map with planes, in SI; NaN where there is none.
double whirl_table_third(const whirl_table *table, size_t point);

/// The length scale of a point, m per unit of length: of all its lengths. That of the result for a table NULL.
double whirl_result_length_scale(const whirl_result *result, const whirl_table *table, size_t point);

/// [whirl_table_points] +1 carried from the first value on, -1 from the last, 0 not carried.
const int *whirl_table_branch(const whirl_table *table);

size_t whirl_table_field_count(const whirl_table *table); ///< Fields of a point.

/// The index of the field of that name; whirl_table_field_count where there is none.
size_t whirl_table_field_index(const whirl_table *table, const char *name);

const char *whirl_table_field_name(const whirl_table *table, size_t field);    ///< "orbit/max_radius"
const char *whirl_table_field_unit(const whirl_table *table, size_t field);    ///< As in whirl_field.
const char *whirl_table_field_meaning(const whirl_table *table, size_t field); ///< One line.
const char *whirl_table_field_extent(const whirl_table *table, size_t field);  ///< "point", "station" or "contact"

/// Whether a field of that name has rows, however many of them options leave: then one row is an array, too. False of
/// names that are not known.
bool whirl_field_has_rows(const char *name);

/// What one unit of a field is in SI, and the name of that in at most `size` bytes ("m"): NaN for lengths where the
/// parameter changes the scale (whirl_result_length_scale).
double whirl_table_field_si(const whirl_result *result, const whirl_table *table, size_t field, char *name,
                            size_t size);

/// Where the numbers of a field lie: those of a point, `shape` = {stations or contacts (1: it is of the point), rows,
/// columns}, one after the other, and those of the next point `stride` doubles on. NULL where the table's blocks are
/// not in memory (whirl_table_copy), as in an outline.
const double *whirl_table_column(const whirl_table *table, size_t field, size_t shape[3], size_t *stride);

/// Copies the numbers of a field, all points, into numbers [points][shape]. WHIRL_IO_ERROR where a block is lost.
whirl_status whirl_table_copy(const whirl_table *table, size_t field, double *numbers);

/// The verdict on a point in words ("P-2") and why, each at most `size` bytes; both "" where the table has none.
void whirl_table_words(const whirl_table *table, size_t point, char *name, char *reason, size_t size);

/// What the points of a basin, or of a table with several starts a place, came to rest on: of every point the number of
/// its attractor, from 1 for that of most starts (0: not done, or without a verdict); the share of the starts, of the
/// basin or of the place, that lead to it (NaN: not told); and the standard error of the share, were the starts drawn
/// at random. Each [whirl_table_points], or NULL: not wanted. 0 and NaN for all points of other tables.
/// WHIRL_NO_MEMORY.
whirl_status whirl_table_attractor_numbers(const whirl_table *table, size_t *numbers, double *shares, double *errors);

/// An option of the table's integration or record by index from 0: its name, and its value as text ("dop853", "1e-9").
/// NULL past the last.
const char *whirl_table_option(const whirl_table *table, size_t index, char *text, size_t size);

/// A figure of a result by its name (NULL: the first), as the JSON document of docs/figures.md; units as reports take
/// them, panels ("x,exponent") and logarithmic axes ("x", "y", "xy") that are chosen, or NULL each. *json is freed by
/// whirl_text_free. WHIRL_BAD_INPUT with a sentence for a figure, panel or unit that there is none of.
whirl_status whirl_result_figure(const whirl_result *result, const char *name, const char *units, const char *panels,
                                 const char *log, char **json);

/// What `whirl balance` answers to the text of a file on balancing (docs/guide/14-balancing.md), as its JSON document;
/// `name` stands for the file in messages, and its folder is where the model is looked for. Where anything is wrong
/// with the file or its model, all of it is written to `problems` as whirl_case_check does. *json is freed by
/// whirl_text_free.
whirl_status whirl_balance_json(const char *text, size_t length, const char *name, char *problems, size_t size,
                                char **json);

/// The figures of a result, a line each: name, tabulator, title. *lines is freed by whirl_text_free.
whirl_status whirl_result_figures(const whirl_result *result, const char *units, char **lines);

/// What was found of machines at rest, of branches, tori and spectra (docs/result-file.md, "Findings as JSON"): the
/// sheet of that name ("peaks", or "TABLE/peaks" where several tables have one), or of a name NULL all statements and
/// sheets. `units` as reports take them, or NULL; `format` is "text" or "json", of a sheet also "csv" or "latex". *text
/// is freed by whirl_text_free. WHIRL_BAD_INPUT with a sentence for a sheet, unit or format that there is none of.
whirl_status whirl_result_findings(const whirl_result *result, const char *sheet, const char *units, const char *format,
                                   char **text);

/// The sheets of a result, a line each: name, by which whirl_result_findings knows it, tabulator, title. *lines is
/// freed by whirl_text_free.
whirl_status whirl_result_sheets(const whirl_result *result, const char *units, char **lines);

void whirl_text_free(char *text); ///< Frees such a text; NULL is none.

/// What `whirl bearing` answers to the text of a file on a bearing (docs/guide/15-bearings.md), as its JSON document,
/// and its figures (curves, sommerfeld, locus) as a list of the documents of docs/figures.md; figures: NULL where they
/// are not wanted. `name` stands for the file in messages; threads: 0 for one a core. All that is wrong with the file
/// is written to `problems` as whirl_case_check does. *json and *figures are freed by whirl_text_free.
whirl_status whirl_bearing_json(const char *text, size_t length, const char *name, int threads, char *problems,
                                size_t size, char **json, char **figures);

#ifdef __cplusplus
}
#endif
#endif
