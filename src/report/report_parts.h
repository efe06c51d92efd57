/// Parts shared by reports, figures and pages.
#ifndef REPORT_REPORT_PARTS_H
#define REPORT_REPORT_PARTS_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/bearing_table.h"
#include "whirl/engine/case.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/findings.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#include <jansson.h>
#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// ---------------------------------------------------------------- document
// Parts of a JSON document.

/// Returns a JSON number; null for NaN and infinity, which JSON lacks.
json_t *document_number(double value);

/// Returns a JSON text; bytes that are not UTF-8 become question marks.
json_t *document_text(const char *text);

/// Add a value to a container, which then owns it; `well` becomes false without memory.
void document_put(bool *well, json_t *object, const char *key, json_t *value);
void document_append(bool *well, json_t *array, json_t *value);

/// Puts all members of a struct that have a name.
void document_put_members(bool *well, json_t *object, const whirl_member *member, const void *from);

/// Writes a value, with digits that restore the same doubles, and frees it. Returns false on failure.
bool document_write(bool well, json_t *value, FILE *stream);

// ---------------------------------------------------------------- explorer
// The explorer's page in units that a report asks for.

/// Like whirl_explorer_write; `units` override those of the case (whirl_result_shown_units), NULL: none. machines
/// [count]: cases of the results (machine_of).
whirl_status explorer_write(const char *template_path, const whirl_result *const *results,
                            const whirl_case *const *machines, const char *const *names, size_t count,
                            const char *directory, const char *units);

// ---------------------------------------------------------------- explorer_tables
// Tables in the explorer's page, thinned to what a browser takes in.

/// Writes one table, with sections on request. Returns false without memory.
bool explorer_write_table(FILE *stream, const whirl_table *table, bool sections);

/// Writes `,"fields": ...`: all fields of one point.
void explorer_write_point(FILE *stream, const whirl_table *table, size_t point);

// ---------------------------------------------------------------- explorer_contents
// Findings of a result in the explorer: statements, sheets and figures of every table.

/// Writes `,"parts": [...],"statements": [...],"sheets": [...],"figures": [...]` for a result with tables of machines
/// at rest, or of motions that the page does not compute; nothing for other results. Returns false without memory.
bool explorer_write_contents(FILE *stream, const whirl_result *result, const whirl_case *machine, const char *units);

// ---------------------------------------------------------------- findings
// Parts shared by renderers of findings.

enum { STATEMENT_SIZE = 2048, SENTENCE_SIZE = 512 };

/// Finds the findings of a view of a result (whirl_result_by_attractor); machine: its case (machine_of), or NULL.
/// WHIRL_NO_MEMORY.
whirl_status findings_of(const whirl_result *view, const whirl_shown_units *units, const whirl_case *machine,
                         whirl_findings **findings);

/// Writes "separation margin, asked for 16 % (amplification 5): 12 % above: left at 3000 rpm: fails: 1 of 4 peaks".
void statement_text(const whirl_statement *statement, char *text, size_t size);

/// Returns true if a column is empty in all rows; pages leave it out.
bool sheet_column_empty(const whirl_sheet *sheet, size_t column);

/// Writes a sheet as aligned text after its title; of more rows than `most` (2 or more) only the first ones and the
/// last. Returns false without memory.
bool sheet_write_text(FILE *stream, const whirl_sheet *sheet, size_t most);

/// Write a sheet as CSV and as LaTeX, in the form of whirl_sheet_write.
void sheet_write_csv(FILE *stream, const whirl_sheet *sheet);
void sheet_write_latex(FILE *stream, const whirl_sheet *sheet);

/// Writes statements and sheets of a table as text: at most `points` rows of sheets of points, at most `rows` of
/// others. Returns false without memory.
bool findings_write_table(FILE *stream, const whirl_findings *findings, const char *table, size_t points, size_t rows);

/// Words a warning of a point of a bearing, or of the bearing as a whole (point NULL), in the units of `units`, or else
/// of its file. Returns false without memory.
bool bearing_remark_text(const whirl_bearing *bearing, const char *units, const whirl_bearing_point *point,
                         whirl_bearing_remark remark, char text[STATEMENT_SIZE]);

/// Writes a sheet as a JSON document. WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status sheet_write_json(const whirl_sheet *sheet, FILE *stream);

/// Return statements and sheets as parts of a JSON document.
json_t *statements_json(bool *well, const whirl_findings *findings);
json_t *sheets_json(bool *well, const whirl_findings *findings);

// ---------------------------------------------------------------- machine_at
// The machine at a point of a result, which its parameter may change, from the case that the result holds.

/// Makes the case of a result, with the parameters of the run; free it with whirl_case_free. NULL if the result has no
/// case, or one that cannot be read. WHIRL_NO_MEMORY.
whirl_status machine_of(const whirl_result *result, whirl_case **machine);

/// Makes the cases of several results [count], freed by machines_free, also after a failure. WHIRL_NO_MEMORY.
whirl_status machines_of(const whirl_result *const *results, size_t count, whirl_case ***machines);
void machines_free(whirl_case **machines, size_t count);

/// Returns the batch of a table in the study of a case, with the second and third parameter of a point; NULL if there
/// is none. A part of *study.
whirl_batch *machine_batch(const whirl_case *machine, const whirl_table *table, size_t point, whirl_study *study);

/// Makes the machine of a point with the values of its batch, but with the case's own unbalances instead of unbalances
/// by rule. The caller releases it. Returns false if it cannot be made.
bool machine_at(const whirl_case *machine, const whirl_table *table, size_t point, whirl_machine *out);

/// Returns the speed at a point, rad/s; NaN if unknown.
double machine_clock(const whirl_case *machine, const whirl_result *result, const whirl_table *table, size_t point);

/// Walls around a station, in length scales of the point; 0: none.
typedef struct machine_walls {
    double clearance; ///< clearance of its bearing
    double gap;       ///< gap to the stator
} machine_walls;

/// Returns the walls at a point, or those of the result's own case if the point's machine is unknown.
machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station);

/// Wall of the bearing or seal around a station: largest eccentricity in WALL_ANGLES directions from the x axis on, in
/// length scales of the point; all the same if it is round.
enum { WALL_ANGLES = 720 };
typedef struct machine_wall {
    bool round;
    double radius[WALL_ANGLES];
} machine_wall;

/// Finds the wall from the bearing's geometry: lobes, offset halves, pivots of tilting pads. A circle of radius
/// `clearance` if the machine cannot be made, or pads have no wall.
void machine_wall_at(const whirl_case *machine, const whirl_table *table, size_t point, size_t station,
                     double clearance, machine_wall *out);

/// Returns the radius in a direction (rad), interpolated linearly.
double machine_wall_radius(const machine_wall *wall, double angle);

// ---------------------------------------------------------------- motions_text
// Nonlinear motions of a lateral analysis in one paragraph: their kinds, their share of clearances, contacts and
// forces, and coexisting motions.

/// Returns true if a table has motions next to studies at rest (study: motions).
bool motions_beside(const whirl_table *table);

enum { MOTIONS_TEXT_SIZE = 4096 };

/// Describes a table of motions in a view (whirl_result_by_attractor) of the result; machine: its case, or NULL.
void motions_text(const whirl_shown_units *units, const whirl_result *view, const whirl_case *machine,
                  const whirl_table *table, char text[MOTIONS_TEXT_SIZE]);

// ---------------------------------------------------------------- named_lines
// Lines of spectra by the names that the machine has for their orders.

enum { LINE_NAME_SIZE = 48 };

/// Finds the name of a line at a station, "BPFO", "2 BPFO" or "BPFI - 1X", and its part. Among equal orders parts at
/// the station come first, then plain orders, multiples, and sidebands of one revolution. Returns false if it has no
/// name.
bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of);

// ---------------------------------------------------------------- law_range_text
// Points outside the validity range of an element's law.

enum { RANGE_TEXT_SIZE = 1024 };

/// Describes validity range `index` of a table: "film at journal: eccentricity ratio up to 0.95, to which its
/// coefficients were found; reached 0.97 (37 of 256 points, first at 6400 rpm)". Returns false if no point has left it.
bool law_range_text(const whirl_shown_units *units, const whirl_table *table, size_t index, char text[RANGE_TEXT_SIZE]);

/// Describes points without an answer in studies at rest: "3 of 53 points, first at 1000 rpm: it could be followed up
/// to 74.3 % of the static load, ...". Returns false if all points have one.
bool no_equilibrium_text(const whirl_shown_units *units, const whirl_table *table, char text[RANGE_TEXT_SIZE]);

/// Describes points at rest with another equilibrium: "there is another one, up to 0.12 mm away, to which that of the
/// value before or after leads, stable (2 of 53 points, first at 8 MN/m)". Returns false if there are none.
bool other_equilibrium_text(const whirl_shown_units *units, const whirl_table *table, char text[RANGE_TEXT_SIZE]);

/// Describes a contact (index) that is closed at rest: "rub at disc with up to 120 N (14 of 171 points, first at 500
/// rpm), which small motions leave as it is there". Returns false if it is open everywhere.
bool closed_contact_text(const whirl_shown_units *units, const whirl_table *table, size_t contact,
                         char text[RANGE_TEXT_SIZE]);

// ---------------------------------------------------------------- regimes
// Regimes as figures and pages show them: classes with colours, and intervals along a sweep.

typedef enum regime_class {
    CLASS_P1 = 0,
    CLASS_P2,
    CLASS_P4,
    CLASS_OTHER_PERIOD,
    CLASS_QUASI_PERIODIC,
    CLASS_CHAOTIC,
    CLASS_UNDETERMINED,
    CLASS_DIVERGED,
    CLASS_NOT_JUDGED, ///< points of tables without verdicts; not in legends of verdicts
    CLASS_COUNT
} regime_class;

regime_class regime_class_of(const whirl_verdict *verdict);

/// "P-1", "other P-k", "chaotic", ... Static text.
const char *regime_class_name(regime_class kind);

/// Returns the colour, "#366EFB", distinguishable with any colour vision; the explorer's are the same
/// (explorer/tests/colours.test.mjs). Static text.
const char *regime_class_colour(regime_class kind);

enum { ATTRACTOR_COLOURS = 8 };

/// Returns the colour of an attractor by number, from 1, repeating after ATTRACTOR_COLOURS. Static text.
const char *attractor_colour(size_t number);

/// Writes "rests", "P-1", "P-8", "quasi-periodic", "chaotic", ...: the part of a verdict that neighbouring points of an
/// interval share.
void regime_name(const whirl_verdict *verdict, char *text, size_t size);

/// Consecutive points of a sweep with the same regime.
typedef struct regime_interval {
    char name[64];
    regime_class kind;
    size_t first, last, count; ///< points of the table
    size_t rubbing;            ///< number of its points with contact
    int branch;
} regime_interval;

/// Merges the points of the table that are done into intervals, in their order. Returns their number; at most `most`
/// are written.
size_t regime_intervals(const whirl_table *table, size_t contact_count, regime_interval *intervals, size_t most);

/// Returns the number of intervals at the beginning that are shown as one: several short ones in a row, else 1.
size_t regime_group(const regime_interval *intervals, size_t count);

/// "P-1"; "changing: P-3, chaotic" of several.
void regime_group_name(const regime_interval *group, size_t count, char *text, size_t size);

// ---------------------------------------------------------------- report_file
// Files of a report: written to a temporary name and renamed, so that none is ever half there.

enum { FILE_PATH_SIZE = 4096 };

typedef struct report_file {
    FILE *stream;
    char path[FILE_PATH_SIZE];
    char temporary[FILE_PATH_SIZE + 8];
} report_file;

/// Opens `folder`/`name` for writing. WHIRL_IO_ERROR with a sentence.
whirl_status report_file_open(report_file *file, const char *folder, const char *name);

/// Closes the file, checks for errors (a full disk) and renames it to its final name. A failed file is removed.
whirl_status report_file_close(report_file *file);

/// Closes and removes an incomplete file; an existing file of the final name stays.
void report_file_drop(report_file *file);

/// Creates a folder and its parents; an existing one is fine.
whirl_status folder_make(const char *path);

/// Returns true if anything of this name exists, even a dangling link.
bool report_file_there(const char *path);

/// Returns true if a folder exists and is not empty.
bool folder_holds_files(const char *path);

/// Creates a folder that only the report writes to; a link in its place is refused.
whirl_status folder_make_own(const char *path);

/// Creates a new folder in another one; path [FILE_PATH_SIZE]. WHIRL_IO_ERROR with a sentence.
whirl_status folder_make_temporary(const char *in, char *path);

/// Removes such a folder and the files in it that have these names, ended by NULL.
void folder_remove(const char *path, const char *const *names);

/// Turns a text into a file name: letters, digits, '.', '_', '+' and '-' stay, other bytes become '-'. The name is
/// never empty and never begins with '.' or '-'.
void safe_name(const char *text, char *name, size_t size);

// ---------------------------------------------------------------- units
// Labels of quantities in figures and pages, in shown units.

enum { UNIT_LABEL_SIZE = 160 };

/// Returns an order of the running speed (rad/s) in the unit of frequencies; NaN if orders are shown, or the speed is
/// unknown.
double units_order(const whirl_shown_units *units, double speed);

/// Writes the label of an axis of orders of the running speed, or of frequencies; `full`: with backward whirl too.
void units_order_label(const whirl_shown_units *units, bool orders, bool full, char *label, size_t size);

/// Returns true if the parameter of a table is the speed of the shaft, by the field `speeds` at every point.
bool units_of_speed(const whirl_table *table, const char *speeds);

/// Returns the direction of whirl from a number between -1 and 1: 1 forward, -1 backward, 0 to and fro.
int units_way(double direction);

/// Returns the factor from a length at a point of the table to its shown value.
double units_length(const whirl_shown_units *units, const whirl_table *table, size_t point, whirl_counting counting);

/// Write an axis label in plain text: "x / c" or "x (um)"; "amplitude / c (0-p)" or "amplitude (um p-p)"; "omega
/// (rpm)".
void units_length_label(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *label,
                        size_t size);
void units_parameter_label(const whirl_shown_units *units, const char *name, char *label, size_t size);

/// "r_k = 0.46", "omega = 6000 rpm, kappa = 10" or "omega = 6000 rpm from the last value", which a motion was carried
/// from; for a table without a parameter its name.
void units_point_label(const whirl_shown_units *units, const whirl_table *table, size_t point, char *label,
                       size_t size);

// ---------------------------------------------------------------- numbers

/// Writes a number with so many significant digits; up to ten million without a power of ten: "140280".
void number_shown(double number, int digits, char *text, size_t size);

// ---------------------------------------------------------------- weight
// Weight on the machine of a result, if the result comes from a case.

/// Size of the text of weight_text.
enum { WEIGHT_SIZE = 256 };

/// Writes "9.80665 m/s2 across the shafts", in the shown unit; "" if unknown.
void weight_text(const whirl_shown_units *units, char *text, size_t size);

/// Returns true if weight acts along the shafts.
bool weight_stands(const whirl_result *result);

/// Returns true if a summary begins with the weight: the machine is vertical, or journals in clearances carry no
/// weight. Statics report it themselves.
bool weight_heads(const whirl_result *result);

// ---------------------------------------------------------------- written
// Output of functions as texts, for programs in other languages.

/// Writes `of`.
typedef whirl_status write_function(const void *of, FILE *stream);

/// Writes into a text, to be freed by whirl_text_free. On failure *text is NULL; out of memory the message is "no
/// memory " and `purpose`.
whirl_status text_written(write_function *write, const void *of, const char *purpose, char **text);

#endif
