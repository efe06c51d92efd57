/// Results: the points of a study, with its case and the way they were computed; in memory and as a file.
#ifndef WHIRL_RESULT_H
#define WHIRL_RESULT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/tolerances.h"
#include "whirl/handles.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Blocks of points that a run left with its store to save memory (whirl_run_options.memory).
typedef struct whirl_journal_blocks whirl_journal_blocks;

/// Limits of neighbour starts.
enum {
    WHIRL_MAX_NEIGHBOUR_STARTS = 16 ///< most starts from neighbours at a parameter value
};

/// Large arrays of a run in unnamed temporary files; the system keeps as much of them in memory as fits.
typedef struct whirl_mapped whirl_mapped;

/// A coexisting attractor at a parameter value, in a study with several starts for each.
typedef struct whirl_coexisting {
    size_t place;        ///< index of the parameter value (whirl_table_place)
    size_t number;       ///< number of the attractor along the study, from 1
    size_t first;        ///< first point of the table that settled on it
    size_t starts;       ///< number of starts that settled on it; 0: only starts from neighbours, which do not count
    size_t of;           ///< starts of the parameter value that are done, with or without a verdict
    size_t coexisting;   ///< number of attractors of the parameter value, with this one
    double share, error; ///< share of the starts that are done, and its standard error for starts drawn at random
} whirl_coexisting;

/// The points of one batch.
struct whirl_table {
    char name[WHIRL_NAME_SIZE];      ///< "sweep", "modes_worn": name in results
    whirl_role role;                 ///< role of its points in the study
    char parameter[WHIRL_NAME_SIZE]; ///< the varied parameter, or ""
    /// The second parameter of a map, whose points have its value in the field "map/second".
    char second[WHIRL_NAME_SIZE];
    size_t row;                  ///< points of a row of a map, along the parameter, by whirl_table_slot; else 0
    char third[WHIRL_NAME_SIZE]; ///< the third parameter of a map, from plane to plane (field "map/third"), or ""
    size_t plane;                ///< points of a plane of the map, row by row; else 0
    /// Starts for each parameter value; the table has all values with the first start, then with the next; or 0.
    size_t starts;
    /// Maximum number of rounds of starts from the ends of neighbours' motions (whirl_batch.neighbours), and number of
    /// parameter values of the study. These points have the slots of further starts, of which any may be missing. Both
    /// 0: no such starts.
    size_t neighbours, places;
    /// For a refined map: number of points of the finest grid, which slots index, and width of the first squares in
    /// grid steps. Squares were halved as long as their points differed. The field "map/width" of a point is the width
    /// of the square that begins at it and whose corners agree, or 1 for the point alone; the point stands for all grid
    /// points of that square (whirl_table_cover). Both 0: not refined.
    size_t grid, refine;
    /// A study of tolerances: the table has all parameter values for the first machine of the samples, then for the
    /// next (whirl_tolerance_machines); 0 samples: none.
    whirl_tolerance_options tolerances;
    size_t count; ///< number of points with a block
    /// Number of points of the study, if it exceeds `count` in a file that was written early; 0: count.
    size_t planned;
    size_t *slots;  ///< [count] their indices in the study, from 0, rising; NULL: the first ones
    double *values; ///< [count] the parameter in SI (NaN if nothing varies)
    /// [count] m per unit of length, if the parameter changes it; NULL: that of the result.
    double *length_scales;
    /// Dependence of the clock (whirl_result_clock) on the point: 0 none, 1 to 3 the parameter, the second or the third
    /// one, times `clock_factor`; WHIRL_CLOCK_UNKNOWN for any other. See whirl_table_clock.
    int clock_of;
    double clock_factor; ///< 1 if nothing varies
    int *branch;         ///< [count] +1 carried from the first value on, -1 carried from the last, 0 not carried
    /// [count][layout.size], NaN for points that are not done; NULL in an outline, and if the blocks are in
    /// `journal_blocks`.
    double *blocks;
    whirl_journal_blocks *journal_blocks; ///< NULL, or the blocks, which the run left with its store
    /// [count] 1 for points that are done, 0 for points that a stopped run did not reach; NULL: all are done.
    unsigned char *done;
    whirl_layout layout;               ///< layout of a block
    whirl_analysis_set analyses;       ///< computed analyses
    whirl_integrate_options integrate; ///< method of the motions
    whirl_record_options record;       ///< contents of the records
    const struct whirl_table *source;  ///< for a view (whirl_result_by_attractor): the table of its points, or NULL
    size_t *chosen;                    ///< [count] indices in that table
    whirl_coexisting *attractors;      ///< [count] attractors of the points
    whirl_mapped *mapped;              ///< NULL, or memory of those arrays that a run made large
};

/// whirl_table.clock_of of a rate that is not recorded.
enum { WHIRL_CLOCK_UNKNOWN = 4 };

/// Returns the first table with that role; NULL if there is none.
const whirl_table *whirl_result_role(const whirl_result *result, whirl_role role);

/// A named parameter of the case with its value in the run, in SI.
typedef struct whirl_parameter {
    char name[WHIRL_NAME_SIZE]; ///< as in the case
    char unit[WHIRL_NAME_SIZE]; ///< SI unit, "1" for a plain number
    char text[128];             ///< text in the case (or --set)
    double value;               ///< in SI
} whirl_parameter;

/// A fact about the run: version, git revision, compiler, flags, libraries, host, start, end, threads.
typedef struct whirl_fact {
    char name[WHIRL_NAME_SIZE]; ///< "version", "compiler", ...
    char value[256];            ///< in words
} whirl_fact;

/// A result: a study with all of its numbers, and the way they were computed.
struct whirl_result {
    char title[256];        ///< title of the case
    char *case_text;        ///< the case file, byte for byte; "" for none
    char case_name[256];    ///< name of the case file
    double speed;           ///< speed of the shaft, rad/s; revolutions and orders are those of whirl_result_clock
    double length_scale;    ///< m per unit of length, of the case at its own parameters; see whirl_result_length_scale
    double force_scale;     ///< N per unit of force; 1 for rotors
    size_t parameter_count; ///< number of parameters
    whirl_parameter *parameters;       ///< [parameter_count]
    size_t station_count;              ///< number of stations
    whirl_probe *stations;             ///< names, state indices, bearing clearances and stator gaps (in length scales)
    size_t contact_count;              ///< number of contacts
    char (*contacts)[WHIRL_NAME_SIZE]; ///< names
    size_t fact_count;                 ///< number of facts
    whirl_fact *facts;                 ///< [fact_count] circumstances of the run
    size_t table_count;                ///< number of tables
    whirl_table *tables;               ///< [table_count]
    bool partial;                      ///< the run was stopped: points are missing, or not all are confirmed or refined
};

/// Returns the block [layout.size] of a point; NULL in an outline, and for a block of journal_blocks that is lost.
/// Borrowed; with journal_blocks only until the next call, by one thread at a time.
const double *whirl_table_block(const whirl_table *table, size_t point);

/// Returns the numbers [rows][columns] of a field for a point and a station or contact (0 for fields of the point);
/// NULL if the table has no such field or an index is out of range. Borrowed like the block.
const double *whirl_table_field(const whirl_table *table, size_t point, const char *field, size_t which);

/// Returns the first of these numbers; NaN if the table has no such field.
double whirl_table_number(const whirl_table *table, size_t point, const char *field, size_t which);

/// Returns the rate, rad/s, of the phase by which sections are taken, for the case at its own parameters: a revolution
/// is a turn of it, and orders are multiples of its rate. It is the speed of the shaft, or the fact "keyphasor rate".
double whirl_result_clock(const whirl_result *result);

/// Returns the element of that phase ("force at disc"), "" for the shaft; borrowed.
const char *whirl_result_keyphasor(const whirl_result *result);

/// Returns the fact "film tables": the film tables of machines of the study (number and checksum), from up to 64 points
/// spread over the study; "" if there are none. Borrowed.
const char *whirl_result_film_tables(const whirl_result *result);

/// Returns true if the motion of a point began at the end of a neighbour's.
bool whirl_table_from_neighbour(const whirl_table *table, size_t point);

/// Returns the number of points of the study in this table, done or not; for a map under refinement as far as it is
/// known.
size_t whirl_table_planned(const whirl_table *table);

/// Finds the point that stands for each point of the grid, cover [whirl_table_grid]: itself if it is done, else the
/// first corner of the square around it; whirl_table.count if neither is done.
void whirl_table_cover(const whirl_table *table, size_t *cover);

/// Returns the mean revolutions of motions of a table, over points that are done; NaN if it has no verdicts.
double whirl_table_revolutions(const whirl_table *table);

/// Returns the revolutions that a refined map's whole grid would take, if each point took as many as the point that
/// stands for it; NaN if that is not known, or memory is exhausted.
double whirl_table_grid_revolutions(const whirl_table *table);

/// Counts the points of the study in all tables and those that are done; returns true for a partial result.
bool whirl_result_partial(const whirl_result *result, size_t *done, size_t *total);

/// Returns the verdict on a point.
whirl_verdict whirl_table_verdict(const whirl_table *table, size_t point);

/// Undetermined motions of a table with the same remedy.
typedef struct whirl_doubt {
    size_t points, first;  ///< number of points, and the first
    whirl_verdict verdict; ///< verdict of the first, with the largest factor of advice among them
} whirl_doubt;

/// Groups the undetermined motions of a table by remedy, doubts [WHIRL_REMEDIES] in the order of remedies; returns the
/// number of groups.
size_t whirl_table_doubts(const whirl_table *table, whirl_doubt doubts[WHIRL_REMEDIES]);

/// Points of a table outside the range of a law.
typedef struct whirl_left {
    size_t points, first; ///< number of points, and the first
    double reached, most; ///< value of the farthest, in the range's unit, and the end of its range
} whirl_left;

/// Finds the points of a table outside range `index` (whirl_result_law_range); returns their number.
size_t whirl_table_left(const whirl_table *table, size_t index, whirl_left *out);

/// Finds the points of a table of machines at rest that rest against a contact, by its index: `reached` is the largest
/// normal force, in units of force, `most` 0. Returns their number.
size_t whirl_table_held(const whirl_table *table, size_t contact, whirl_left *out);

/// Finds the points of a table of machines at rest without an equilibrium; returns their number. `reached` is the
/// smallest share of the static load up to which one could be followed; NaN if another machine of the study (without
/// stages, at another speed) has no equilibrium.
size_t whirl_table_unfound(const whirl_table *table, whirl_left *out);

/// Finds the points of a table of machines at rest with another equilibrium, to which that of a neighbouring value
/// leads; returns their number. `reached` is the largest distance of a station between both, in length scales, `most`
/// the growth at the other equilibrium of the first point, 1/s: it is stable below 0.
size_t whirl_table_elsewhere(const whirl_table *table, whirl_left *out);

/// Reads a point of a table of branches or curves; its orbit is freed by whirl_orbit_free. Errors as whirl_block_trace.
whirl_status whirl_table_trace(const whirl_table *table, size_t point, whirl_trace *trace);

/// The points of one branch of tori.
typedef struct whirl_tori {
    size_t first, last; ///< indices in the table
    size_t found;       ///< tori among them: 0 if none begins, else all
    size_t stable;      ///< stable tori
    /// Station and axis (0 x, 1 y) with the largest line at the second frequency, at the last point.
    size_t station, axis;
} whirl_tori;

/// Finds the branch of tori from the point `first` on, in a table with the analysis "torus".
whirl_tori whirl_table_tori(const whirl_table *table, size_t first);

/// Neighbouring points of a sweep with one regime whose motions differ far more than those around them.
typedef struct whirl_jump {
    size_t from, to; ///< points of the table
    size_t station;  ///< station with the largest change
    double change;   ///< change of the motion's mean position or bounds, over the size of the motion
    double usual;    ///< median of such changes between the neighbouring points on both sides
} whirl_jump;

/// Finds jumps along a table: changes by more than 3 % of the motion's size and 8 times the change between points
/// around. A jump may be a change between coexisting motions, or a sudden change of one (a crisis); the table does
/// not show which. Maps have none, nor tables without the analysis "orbit". *count is their number; at most `most` are
/// written. WHIRL_NO_MEMORY.
whirl_status whirl_table_jumps(const whirl_table *table, whirl_jump *jumps, size_t most, size_t *count);

/// An attractor of several points of a table.
typedef struct whirl_attractor {
    size_t first;        ///< first point of the table that settled on it
    size_t points;       ///< number of points; in a refined table points of its grid (whirl_table_cover)
    double share, error; ///< share of the points that are done, and its standard error for starts drawn at random
} whirl_attractor;

/// Finds the attractors of a table of equal machines, such as a basin. Points share an attractor if they share the
/// regime and
/// - for periodic motions, sections that agree to a thousandth of the largest displacement, from any revolution on (one
///   period may be a multiple of the other, as a motion not quite settled may seem to have);
/// - else means and bounds that agree to a fifth of the extent.
///
/// All diverging points share one. Without the analyses "poincare" and "orbit" only regimes and periods are compared.
/// Writes the attractor of each point to labels [count] (NULL: not wanted), from 1, largest first; 0 for points that
/// are not done or have no verdict, and beyond 64 attractors. *count is their number; at most `most` are written.
/// WHIRL_NO_MEMORY.
whirl_status whirl_table_attractors(const whirl_table *table, size_t *labels, whirl_attractor *attractors, size_t most,
                                    size_t *count);

/// The coexisting attractors of a table.
typedef struct whirl_coexistence {
    size_t places;           ///< number of parameter values
    size_t attractors;       ///< number of attractors along the study
    size_t count;            ///< number of items
    whirl_coexisting *items; ///< [count] by parameter value, then by number
    size_t *labels;          ///< [table->count] attractor number of each point; 0: not done, or without a verdict
} whirl_coexistence;

/// Finds the attractors of the starts at each parameter value, as whirl_table_attractors does, and numbers them along
/// the study, from 1 for the attractor of most starts. Attractors of neighbouring values (along a sweep; along all axes
/// of a map) have the same number if each is the nearest of the other and they differ by less than half of the larger
/// one's extent. The difference of two periodic motions is the largest distance of a point of one section from the
/// nearest point of the other. So a number continues through a period doubling. If neither period is a multiple of the
/// other, the motions differ. Other motions are compared by means and bounds. Values without any verdict are skipped.
/// Two attractors of one value never share a number. An attractor that no start reached at a value in between continues
/// with a new number. Motions from neighbours are included, but do not count in shares. Needs the analyses "poincare"
/// and "orbit". WHIRL_NO_MEMORY. Freed by whirl_coexistence_free.
whirl_status whirl_table_coexistence(const whirl_table *table, whirl_coexistence *found);

/// Frees the contents; the struct itself is the caller's.
void whirl_coexistence_free(whirl_coexistence *found);

/// Returns the attractor of a point of the table; NULL if none was assigned. Borrowed.
const whirl_coexisting *whirl_coexistence_at(const whirl_coexistence *found, const whirl_table *table, size_t point);

/// Returns the share of an attractor that all `starts` of a parameter value miss with a probability of 1/20: 1 -
/// 0.05^(1/starts).
double whirl_missed_share(size_t starts);

/// Builds a view of a result in which every coexisting attractor occurs once: attractor by attractor along the study,
/// with its number in `branch`, and the block of the first start that settled on it; for a map the attractor of most
/// starts at each value. All else is borrowed from the result, which may be a view, too, and must live as long.
/// WHIRL_NO_MEMORY. Freed by whirl_result_view_free.
whirl_status whirl_result_by_attractor(const whirl_result *result, whirl_result **view);

/// Frees a view, not what it borrows; accepts NULL.
void whirl_result_view_free(whirl_result *view);

/// A unit in which numbers are shown, with its size in SI. "" and 1 for plain numbers.
typedef struct whirl_unit {
    char name[WHIRL_NAME_SIZE]; ///< its symbol
    double size;                ///< its size in SI
} whirl_unit;

/// Returns the unit in which the case (or --set) gives a parameter: "rpm" of 2 pi/60 rad/s for "6000 rpm". The unit of
/// a sweep's values takes precedence. An expression has the unit of its first parameter of the same kind. The SI unit
/// if none is given, and for zeros; that of plain numbers for names that are not parameters.
whirl_unit whirl_result_unit(const whirl_result *result, const char *parameter);

/// Returns the unit for lengths of the result: that in which the case gives the parameter of the length scale, else m,
/// mm or um by the size of the scale.
whirl_unit whirl_result_length_unit(const whirl_result *result);

/// Returns the SI size of one unit of a field: for "length" and "force" the scales of the result, for revolutions and
/// orders the rate of its clock, for any other unit itself. NaN for lengths if the table's parameter changes the scale
/// (whirl_result_length_scale), for revolutions and orders if it changes the clock (whirl_table_clock); a table NULL
/// has the scale and clock of the result.
whirl_unit whirl_result_si(const whirl_result *result, const whirl_table *table, const char *unit);

/// Returns the same for a field's numbers; the second and third parameters of a map have their own units.
whirl_unit whirl_field_si(const whirl_result *result, const whirl_table *table, const whirl_field *field);

/// Returns the SI unit of a parameter, "1" for plain numbers and unknown names. Borrowed.
const char *whirl_result_parameter_unit(const whirl_result *result, const char *parameter);

/// Returns the options with which a table was computed, group by group from 0: their members, and the offset in the
/// table of the struct that has these members; NULL past the last group.
const whirl_member *whirl_table_options(const whirl_table *table, size_t group, size_t *offset);

/// Returns the value of a fact, "" if there is none of that name. Borrowed.
const char *whirl_result_fact(const whirl_result *result, const char *name);

/// Returns a warning of the result, by index from 0: values of the case outside the range of a law or unusual for any
/// machine, ranges without extent. "" past the last. Borrowed.
const char *whirl_result_warning(const whirl_result *result, size_t index);

/// Returns a note on the fit that replaces a bearing's table over the frequency of whirl in motions, with its error, by
/// index from 0. "" past the last. Borrowed.
const char *whirl_result_fit(const whirl_result *result, size_t index);

/// Returns a range of validity of the machine's laws, by index from 0, in the order of the rows of
/// WHIRL_FIELD_RANGES_REACHED: "film at journal: eccentricity ratio up to 0.95, to which its coefficients were found".
/// "" past the last. Borrowed.
const char *whirl_result_law_range(const whirl_result *result, size_t index);

/// Appends the facts of this build and host: version, revision, compiler, flags, libraries, host, processor,
/// instruction set.
whirl_status whirl_result_add_provenance(whirl_result *result);

/// Returns true if two results have the same case, study and parameters, whatever their numbers. If not, writes the
/// first difference in at most `size` bytes ("line 5 of the case was 'a' and is 'b'"). Not for partial files, which
/// lack points.
bool whirl_result_same_study(const whirl_result *earlier, const whirl_result *later, char *difference, size_t size);

/// Writes every table as CSV files into the directory `path` (created if missing): one file with a line per point, and
/// one file per field with rows. Headings contain units.
whirl_status whirl_result_export_csv(const whirl_result *result, const char *path);

/// Returns true if the export would replace a file, and writes the path of the first one, at most `size` bytes.
bool whirl_result_find_csv(const whirl_result *result, const char *path, char *found, size_t size);

/// Converts the result file `result` to a compressed MAT file of version 5 for MATLAB and Octave: one variable per
/// group of the result file (docs/result-file.md), numbers to the bit. `path` is written completely or not at all, and
/// replaced if it exists. WHIRL_BAD_INPUT if `result` is damaged, WHIRL_IO_ERROR if either file fails or a variable
/// would exceed the 2 GB of such files.
whirl_status whirl_result_export_mat(const char *result, const char *path);

/// Writes the points as one JSON document ({"points": [...]}), as described in the user guide.
whirl_status whirl_result_write_json(const whirl_result *result, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
