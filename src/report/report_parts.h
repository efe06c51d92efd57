/// What reports, figures and pages have in common.
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

/// A number; null for what is missing or infinite, which JSON has no number for.
json_t *document_number(double value);

/// A text; what is not UTF-8 in it becomes question marks.
json_t *document_text(const char *text);

/// Put a value, which they take over, into a container; `well` becomes false where memory ran out.
void document_put(bool *well, json_t *object, const char *key, json_t *value);
void document_append(bool *well, json_t *array, json_t *value);

/// Puts all members of a struct that have a name.
void document_put_members(bool *well, json_t *object, const whirl_member *member, const void *from);

/// Writes a value, with the digits that give the same doubles back, and lets go of it. False where it fails.
bool document_write(bool well, json_t *value, FILE *stream);

// ---------------------------------------------------------------- explorer
// The explorer's page in units that a report asks for.

/// As whirl_explorer_write; `units` go before those of the case (whirl_result_shown_units), NULL: none are asked for.
whirl_status explorer_write(const char *template_path, const whirl_result *const *results, const char *const *names,
                            size_t count, const char *directory, const char *units);

// ---------------------------------------------------------------- explorer_tables
// Tables in the explorer's page, thinned to what a browser takes in.

/// One table, with sections where they are asked for; false without memory.
bool explorer_write_table(FILE *stream, const whirl_table *table, bool sections);

/// `,"fields": ...` of one point: all that is known of it.
void explorer_write_point(FILE *stream, const whirl_table *table, size_t point);

// ---------------------------------------------------------------- explorer_contents
// What was found of a result, in the explorer: statements, sheets and figures of every table.

/// Writes `,"parts": [...],"statements": [...],"sheets": [...],"figures": [...]` of a result that has tables of
/// machines at rest, or of motions that the page does not compute; of all others nothing. False without memory.
bool explorer_write_contents(FILE *stream, const whirl_result *result, const char *units);

// ---------------------------------------------------------------- findings
// What renderers of findings have in common.

enum { STATEMENT_SIZE = 2048 };

/// What was found in a view of a result (whirl_result_by_attractor). WHIRL_NO_MEMORY.
whirl_status findings_of(const whirl_result *view, const whirl_shown_units *units, whirl_findings **findings);

/// "separation margin, asked for 16 % (amplification 5): 12 % above: left at 3000 rpm: fails: 1 of 4 peaks".
void statement_text(const whirl_statement *statement, char *text, size_t size);

/// Whether a column has nothing in any row: pages leave it out.
bool sheet_column_empty(const whirl_sheet *sheet, size_t column);

/// A sheet as aligned text, its title first; of more rows than `most` (2 or more) the first ones and the last.
/// False without memory.
bool sheet_write_text(FILE *stream, const whirl_sheet *sheet, size_t most);

/// ... as CSV and as LaTeX, as whirl_sheet_write has them.
void sheet_write_csv(FILE *stream, const whirl_sheet *sheet);
void sheet_write_latex(FILE *stream, const whirl_sheet *sheet);

/// Statements and sheets of a table as text; of sheets whose rows are points at most `points` rows, of others `rows`.
/// False without memory.
bool findings_write_table(FILE *stream, const whirl_findings *findings, const char *table, size_t points, size_t rows);

/// Words a warning of a point of a bearing, or of the bearing as a whole (point NULL), in um and degC. False without
/// memory.
bool bearing_remark_text(const whirl_bearing *bearing, const whirl_bearing_point *point, whirl_bearing_remark remark,
                         char text[STATEMENT_SIZE]);

/// A sheet as a JSON document. WHIRL_NO_MEMORY, WHIRL_IO_ERROR.
whirl_status sheet_write_json(const whirl_sheet *sheet, FILE *stream);

/// As parts of a JSON document.
json_t *statements_json(bool *well, const whirl_findings *findings);
json_t *sheets_json(bool *well, const whirl_findings *findings);

// ---------------------------------------------------------------- machine_at
// The machine at a point of a result, which its parameter may change, from the case that the result holds.

/// The case that a result came from, with the parameters that the run used, to be freed by whirl_case_free; NULL where
/// it holds none that can be read. WHIRL_NO_MEMORY.
whirl_status machine_of(const whirl_result *result, whirl_case **machine);

/// The batch of a table in the study of a case, with the second and third parameter of a point; NULL where there is
/// none. A part of *study.
whirl_batch *machine_batch(const whirl_case *machine, const whirl_table *table, size_t point, whirl_study *study);

/// The machine of a point as the study has it, with the values of its condition, but with its own unbalances where the
/// study places others; false where it cannot be made. To be released.
bool machine_at(const whirl_case *machine, const whirl_table *table, size_t point, whirl_machine *out);

/// rad/s; NaN where it cannot be told.
double machine_clock(const whirl_case *machine, const whirl_result *result, const whirl_table *table, size_t point);

/// What is around a station, in length scales of the point; 0: nothing.
typedef struct machine_walls {
    double clearance; ///< of its bearing
    double gap;       ///< to the stator
} machine_walls;

/// Of a point, or of the result's own case where the point cannot be told of.
machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station);

/// The wall of the bearing or seal around a station: how far the middle of the journal can go in directions from the
/// x axis on, WALL_ANGLES of them, in length scales of the point; all the same where it is round.
enum { WALL_ANGLES = 720 };
typedef struct machine_wall {
    bool round;
    double radius[WALL_ANGLES];
} machine_wall;

/// Finds it by the geometry of the bearing itself: lobes, offset halves, pivots of pads that tilt; a circle of
/// `clearance` where the machine cannot be made, or pads have no wall.
void machine_wall_at(const whirl_case *machine, const whirl_table *table, size_t point, size_t station,
                     double clearance, machine_wall *out);

/// Its radius in a direction, rad, between those known by a straight line.
double machine_wall_radius(const machine_wall *wall, double angle);

// ---------------------------------------------------------------- motions_told
// What motions in the real films do beside a lateral analysis, in one paragraph: whether they come back, what they take
// of clearances, where they touch and how hard, and what else stands beside them.

/// Whether a table is of motions that stand beside studies of machines at rest (study: motions).
bool motions_beside(const whirl_table *table);

enum { MOTIONS_TOLD_SIZE = 4096 };

/// Of a table of motions, in a view (whirl_result_by_attractor) of the result. WHIRL_NO_MEMORY.
whirl_status motions_told(const whirl_shown_units *units, const whirl_result *view, const whirl_table *table,
                          char text[MOTIONS_TOLD_SIZE]);

// ---------------------------------------------------------------- named_lines
// Lines of spectra by the names that the machine has for their orders.

enum { LINE_NAME_SIZE = 48 };

/// The name of a line at a station, "BPFO", "2 BPFO" or "BPFI - 1X", and whose it is; of equal orders those of parts at
/// the station come first, then single ones, multiples, and sidebands of one revolution. False where it has none.
bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of);

// ---------------------------------------------------------------- ranges_told
// What is told of points beyond the range of a law.

enum { RANGES_TOLD_SIZE = 1024 };

/// Of range `index` of a table: "film at journal: eccentricity ratio up to 0.95, to which its coefficients were found;
/// reached 0.97 (37 of 256 points, first at 6400 rpm)"; false where no point has left it.
bool ranges_told(const whirl_shown_units *units, const whirl_table *table, size_t index, char text[RANGES_TOLD_SIZE]);

/// Of machines at rest: "3 of 53 points, first at 1000 rpm: it could be followed up to 74.3 % of the static load, ...";
/// false where all points have an answer.
bool unfound_told(const whirl_shown_units *units, const whirl_table *table, char text[RANGES_TOLD_SIZE]);

/// Of a contact, by its index, of machines at rest: "rub at disc with up to 120 N (14 of 171 points, first at 500 rpm),
/// which small motions leave as it is there"; false where it is open everywhere.
bool held_told(const whirl_shown_units *units, const whirl_table *table, size_t contact, char text[RANGES_TOLD_SIZE]);

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
    CLASS_NOT_JUDGED, ///< of tables without verdicts; legends of verdicts leave it out
    CLASS_COUNT
} regime_class;

regime_class regime_class_of(const whirl_verdict *verdict);

/// "P-1", "other P-k", "chaotic", ... Static text.
const char *regime_class_name(regime_class kind);

/// "#366EFB": told apart by readers of any colour vision; the explorer's are the same
/// (explorer/tests/colours.test.mjs). Static text.
const char *regime_class_colour(regime_class kind);

enum { ATTRACTOR_COLOURS = 8 };

/// The colour of an attractor by its number, from 1; those beyond ATTRACTOR_COLOURS begin anew. Static text.
const char *attractor_colour(size_t number);

/// "rests", "P-1", "P-8", "quasi-periodic", "chaotic", ...: a verdict without what is different from point to point;
/// what neighbouring points must share to make an interval.
void regime_name(const whirl_verdict *verdict, char *text, size_t size);

/// Consecutive points of a sweep with the same regime.
typedef struct regime_interval {
    char name[64];
    regime_class kind;
    size_t first, last, count; ///< points of the table
    size_t rubbing;            ///< of these, points in contact at some time
    int branch;
} regime_interval;

/// Merges the points of the table that are done into intervals, in their order. Returns their number; at most `most`
/// are written.
size_t regime_intervals(const whirl_table *table, size_t contact_count, regime_interval *intervals, size_t most);

/// How many of the intervals, from the first on, are told as one: several short ones in a row, else 1.
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

/// Closes the file, looks for errors (a full disk) and gives it its name. A file that failed is removed.
whirl_status report_file_close(report_file *file);

/// Closes and removes a file that cannot be completed; one that had its name stays.
void report_file_drop(report_file *file);

/// Makes a folder and those above it; one that is there already is fine.
whirl_status folder_make(const char *path);

/// Whether anything is there by this name, a link that leads nowhere, too.
bool report_file_there(const char *path);

/// Whether a folder is there and has anything in it.
bool folder_holds_files(const char *path);

/// The same for a folder that only the report writes to: a link in its place is refused, for it may lead anywhere.
whirl_status folder_make_own(const char *path);

/// Makes a folder of its own in another one; path [FILE_PATH_SIZE]. WHIRL_IO_ERROR with a sentence.
whirl_status folder_make_temporary(const char *in, char *path);

/// Removes such a folder and the files in it that have these names, ended by NULL.
void folder_remove(const char *path, const char *const *names);

/// The text as a file name: letters, digits, '.', '_', '+' and '-' stay, all else becomes '-'; never empty,
/// never beginning with '.' or '-'.
void safe_name(const char *text, char *name, size_t size);

// ---------------------------------------------------------------- units
// How figures and pages call quantities, in the units in which they are shown.

enum { UNIT_LABEL_SIZE = 160 };

/// What an order of the running speed (rad/s) is in the unit of frequencies; NaN where they are shown as orders, or the
/// speed is not known.
double units_order(const whirl_shown_units *units, double speed);

/// The axis of orders of the running speed, or of the frequencies that they are; `full`: of backward whirl, too.
void units_order_label(const whirl_shown_units *units, bool orders, bool full, char *label, size_t size);

/// Whether the parameter of a table is the speed of the shaft, which the field `speeds` has of every point.
bool units_of_speed(const whirl_table *table, const char *speeds);

/// Which way a mode whirls by its direction, from -1 to 1: 1 forward, -1 backward, 0 to and fro.
int units_way(double direction);

/// What a length of a point of the table is multiplied by to be shown.
double units_length(const whirl_shown_units *units, const whirl_table *table, size_t point, whirl_counting counting);

/// How an axis is called, for plain text: "x / c" or "x (um)"; "amplitude / c (0-p)" or "amplitude (um p-p)"; "omega
/// (rpm)".
void units_length_label(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *label,
                        size_t size);
void units_parameter_label(const whirl_shown_units *units, const char *name, char *label, size_t size);

/// "r_k = 0.46", "omega = 6000 rpm, kappa = 10" or "omega = 6000 rpm from the last value", which a motion was carried
/// from; for a table without a parameter its name.
void units_point_label(const whirl_shown_units *units, const whirl_table *table, size_t point, char *label,
                       size_t size);

// ---------------------------------------------------------------- weight
// How weight acts on the machine of a result, which knows it of cases.

/// "9.80665 m/s2 across the shafts"; "" where it is not known.
const char *weight_told(const whirl_result *result);

/// Returns true where it acts along the shafts.
bool weight_stands(const whirl_result *result);

/// Returns true where a summary begins with it: the machine stands, or journals in clearances have none. Statics say it
/// themselves.
bool weight_heads(const whirl_result *result);

// ---------------------------------------------------------------- written
// What functions write, as texts for programs in other languages.

/// Writes `of`.
typedef whirl_status write_function(const void *of, FILE *stream);

/// What it writes, to be freed by whirl_text_free; *text is NULL after a failure, of memory with "no memory " and
/// `purpose`.
whirl_status text_written(write_function *write, const void *of, const char *purpose, char **text);

#endif
