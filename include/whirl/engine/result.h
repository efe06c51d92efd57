/// Results: what a run found, with the case it came from and how it was computed; in memory and as a file.
#ifndef WHIRL_RESULT_H
#define WHIRL_RESULT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/analyze.h"
#include "whirl/handles.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Blocks that a run left with its keeper, for they are many (whirl_run_options.memory).
typedef struct whirl_kept_blocks whirl_kept_blocks;

enum {
    WHIRL_MAX_NEIGHBOUR_STARTS = 16 ///< starts of a place from neighbours
};

/// Arrays that lie in nameless files, of which the system keeps in memory what it has room for.
typedef struct whirl_room whirl_room;

/// One of the attractors at a place of a study, where several starts a place were followed.
typedef struct whirl_coexisting {
    size_t place;        ///< whirl_table_place
    size_t number;       ///< of the attractor along the study, from 1
    size_t first;        ///< point of the table, the first that came to rest on it
    size_t starts;       ///< that did; 0: only those from neighbours did, which do not count
    size_t of;           ///< starts of the place that are done, with a verdict or without
    size_t beside;       ///< attractors of the place, this one included
    double share, error; ///< of the starts that are done, and its standard error were these drawn at random
} whirl_coexisting;

/// The points of one batch.
struct whirl_table {
    char name[WHIRL_NAME_SIZE];      ///< "sweep", "modes_worn": as whoever reads the result calls it
    whirl_role role;                 ///< of its points in the study
    char parameter[WHIRL_NAME_SIZE]; ///< what varies, or ""
    char second[WHIRL_NAME_SIZE];    ///< what varies besides, in a map, whose points have it in the field "map/second"
    size_t row;                      ///< points of a row of a map, along the parameter, by whirl_table_slot; else 0
    char third[WHIRL_NAME_SIZE];     ///< what varies from plane to plane of a map (field "map/third"), or ""
    size_t plane;                    ///< points of such a plane, row after row; else 0
    size_t starts;                   ///< of every place: all places from the first start, then from the next; or 0
    /// Rounds, at most, of starts from the ends of neighbours' motions (whirl_batch.neighbours), of which places of the
    /// study have any number: their slots go on as those of further starts, and are not all there. Both 0: none.
    size_t neighbours, places;
    /// Of a map that was refined: points of the finest grid, of which slots are the indices, and how many of them apart
    /// corners of first squares stand along either axis. A square was halved while its points differed; its points have
    /// in the field "map/width" how many points of the grid, from itself on along both axes, they stand for: 1 for
    /// itself alone, or the width of a square that begins there, whose corners agree (whirl_table_cover). Both 0: none.
    size_t grid, refine;
    size_t count; ///< points of which there is a block
    /// Points of the study, of which a file that was written too early has `count`; 0: count.
    size_t planned;
    size_t *slots;  ///< [count] which of them these are, from 0, rising; NULL: the first ones
    double *values; ///< [count] of the parameter in SI (NaN when nothing varies)
    /// [count] m per unit of length, where the parameter changes it; NULL: that of the result holds for all.
    double *length_scales;
    /// By what the clock (whirl_result_clock) varies from point to point: 0 nothing, 1 to 3 the parameter, the second
    /// or the third one, times `clock_factor`; WHIRL_CLOCK_UNKNOWN in another way. See whirl_table_clock.
    int clock_of;
    double clock_factor; ///< 1 where nothing varies
    int *branch;         ///< [count] +1 carried from the first value on, -1 carried from the last, 0 not carried
    /// [count][layout.size], NaN where a point is not done; NULL in an outline, and where the blocks are `kept`.
    double *blocks;
    whirl_kept_blocks *kept; ///< NULL, or where the blocks are
    /// [count] 1 for points that are done, 0 for those that a run did not come to; NULL: all are done.
    unsigned char *done;
    whirl_layout layout;               ///< of a block
    whirl_analysis_set analyses;       ///< that were computed
    whirl_integrate_options integrate; ///< by which motions were computed
    whirl_record_options record;       ///< what was recorded
    const struct whirl_table *source;  ///< of a view (whirl_result_by_attractor): whose points these are, or NULL
    size_t *chosen;                    ///< [count] which of them
    whirl_coexisting *attractors;      ///< [count] what they came to rest on
    whirl_room *room;                  ///< NULL, or what those of these arrays lie in that a run made large
};

enum { WHIRL_CLOCK_UNKNOWN = 4 };

/// The first table with that role; NULL where there is none.
const whirl_table *whirl_result_role(const whirl_result *result, whirl_role role);

/// A named parameter of the case with the value that the run used, in SI.
typedef struct whirl_parameter {
    char name[WHIRL_NAME_SIZE]; ///< as in the case
    char unit[WHIRL_NAME_SIZE]; ///< SI unit, "1" for a plain number
    char text[128];             ///< as the case (or --set) gave it
    double value;               ///< in SI
} whirl_parameter;

/// A fact about the run: version, git revision, compiler, flags, libraries, host, start, end, threads.
typedef struct whirl_fact {
    char name[WHIRL_NAME_SIZE]; ///< "version", "compiler", ...
    char value[256];            ///< in words
} whirl_fact;

/// A result: a study with every number, and how it was computed.
struct whirl_result {
    char title[256];             ///< of the case
    char *case_text;             ///< the case file, byte for byte; "" when there was none
    char case_name[256];         ///< of its file
    double speed;                ///< of the shaft, rad/s; revolutions and orders are those of whirl_result_clock
    double length_scale;         ///< m per unit of length, of the case as it stands; see whirl_result_length_scale
    double force_scale;          ///< N per unit of force; 1 for rotors
    size_t parameter_count;      ///< of parameters
    whirl_parameter *parameters; ///< [parameter_count]
    size_t station_count;        ///< of stations
    whirl_probe *stations;       ///< names, state indices, bearing clearances and stator gaps (in length scales)
    size_t contact_count;        ///< of contacts
    char (*contacts)[WHIRL_NAME_SIZE]; ///< names
    size_t fact_count;                 ///< of facts
    whirl_fact *facts;                 ///< [fact_count] how it was computed
    size_t table_count;                ///< of tables
    whirl_table *tables;               ///< [table_count]
    bool partial; ///< the run was stopped: points are missing, or some are not confirmed or refined as they should be
};

/// The block [layout.size] of a point; NULL in an outline, and where it was kept and is lost. Borrowed; from a table
/// whose blocks are kept only until another point is asked for, by one thread at a time.
const double *whirl_table_block(const whirl_table *table, size_t point);

/// The numbers [rows][columns] of a field for a point and a station or contact (0 for fields of the point);
/// NULL when the table has no such field or an index is out of range. Borrowed as the block is.
const double *whirl_table_field(const whirl_table *table, size_t point, const char *field, size_t which);

/// The first of these numbers; NaN where the table has no such field.
double whirl_table_number(const whirl_table *table, size_t point, const char *field, size_t which);

/// rad/s of the phase by which sections are taken: a revolution is a turn of it, and orders are multiples of its rate.
/// The speed of the shaft, or what the fact "keyphasor rate" says, of the case as it stands.
double whirl_result_clock(const whirl_result *result);

/// The element whose phase that is ("force at disc"), "" for the shaft; borrowed.
const char *whirl_result_keyphasor(const whirl_result *result);

/// The fact "film tables": the tables of films that the machines of the study read, as whirl_film_tables_text has them,
/// of up to 64 points that are spread over it; "" where it has none. Borrowed.
const char *whirl_result_film_tables(const whirl_result *result);

/// Whether the motion of a point began at the end of a neighbour's.
bool whirl_table_from_neighbour(const whirl_table *table, size_t point);

/// How many points of the table the study has, done or not; of a map that is being refined as far as is known.
size_t whirl_table_planned(const whirl_table *table);

/// The point that stands for each point of the grid, cover [whirl_table_grid]: itself where it is done, else the first
/// corner of the square around it; whirl_table.count where neither is there.
void whirl_table_cover(const whirl_table *table, size_t *cover);

/// Revolutions that motions of a table took, on the average of the points that are done; NaN where it has no verdicts.
double whirl_table_revolutions(const whirl_table *table);

/// Those that all points of the grid of a refined map would have taken, if each takes as many as the one that stands
/// for it; NaN where that cannot be told, or there is no memory.
double whirl_table_grid_revolutions(const whirl_table *table);

/// Counts the points of the study in all tables and those that are done; true when the result is partial.
bool whirl_result_partial(const whirl_result *result, size_t *done, size_t *total);

/// The verdict on a point.
whirl_verdict whirl_table_verdict(const whirl_table *table, size_t point);

/// Undetermined motions of a table that the same remedy would tell.
typedef struct whirl_doubt {
    size_t points, first;  ///< how many there are, and the first of them
    whirl_verdict verdict; ///< of the first, but that its advice has the largest factor that one of them needs
} whirl_doubt;

/// Why motions of a table are undetermined, doubts [WHIRL_REMEDIES], in the order of the remedies; gives how many.
size_t whirl_table_doubts(const whirl_table *table, whirl_doubt doubts[WHIRL_REMEDIES]);

/// Points of a table that left the range of a law.
typedef struct whirl_left {
    size_t points, first; ///< how many there are, and the first of them
    double reached, most; ///< of the one that went furthest, in the range's unit, and where the range ended there
} whirl_left;

/// Points of a table that left range `index` (whirl_result_law_range); gives how many.
size_t whirl_table_left(const whirl_table *table, size_t index, whirl_left *out);

/// Points of a table of machines at rest that rest against a contact, by its index: reached is the largest normal
/// force, in units of force, most 0; gives how many.
size_t whirl_table_held(const whirl_table *table, size_t contact, whirl_left *out);

/// Points of a table of machines at rest that have no answer, as no place of rest was found there; gives how many.
/// reached is the least share of the static load up to which one could be followed; NaN where it is another machine
/// that the study needs which rests nowhere (without stages, at another speed).
size_t whirl_table_unfound(const whirl_table *table, whirl_left *out);

/// A point of a table of branches or curves; its orbit is freed by whirl_orbit_free. Errors as whirl_block_trace.
whirl_status whirl_table_trace(const whirl_table *table, size_t point, whirl_trace *trace);

/// The points of one branch of tori.
typedef struct whirl_tori {
    size_t first, last; ///< of the table
    size_t found;       ///< tori among them: 0 where none begins, else all
    size_t stable;      ///< of them
    size_t station;     ///< whose line of the second frequency is largest at the last one,
    size_t axis;        ///< and of which coordinate: 0 x, 1 y
} whirl_tori;

/// Those from the point `first` on of a table with the analysis "torus".
whirl_tori whirl_table_tori(const whirl_table *table, size_t first);

/// Neighbouring points of a sweep with one regime whose motions differ far more than those around them.
typedef struct whirl_jump {
    size_t from, to; ///< points of the table
    size_t station;  ///< whose motion changes most
    double change;   ///< of its mean position or its bounds, over its size
    double usual;    ///< the median of the same from point to point around the two
} whirl_jump;

/// Looks for jumps along a table: changes of more than 3 % of the motion's size and 8 times what the points around
/// show. Two motions may exist side by side there, or one changes suddenly (a crisis): that there is a jump does not
/// tell which. Of maps none. *count is how many there are; at most `most` are written. None where the analysis "orbit"
/// is missing. WHIRL_NO_MEMORY.
whirl_status whirl_table_jumps(const whirl_table *table, whirl_jump *jumps, size_t most, size_t *count);

/// A motion that several points of a table came to rest on.
typedef struct whirl_attractor {
    size_t first;        ///< point of the table, the first that did
    size_t points;       ///< that did; of a refined table points of its grid (whirl_table_cover)
    double share, error; ///< of the points that are done, and its standard error were these drawn at random
} whirl_attractor;

/// Tells apart the attractors of a table whose machines are all the same, as those of a basin are: points have one
/// attractor that have one regime and, where it is periodic, sections that agree to a thousandth of the largest
/// displacement, whichever revolution they begin with (one period may be a multiple of the other: a motion that has not
/// quite come to its orbit may seem to have one); where not, means and bounds that agree to a fifth of the extent. All
/// that diverge have one. Needs the analyses "poincare" and "orbit" for that; without them regimes and periods count
/// alone. Writes the attractor of every point to labels [count] (NULL: not wanted), from 1, that of most points first;
/// 0 for points that are not done or without a verdict, and beyond 64 attractors. *count is how many there are; at most
/// `most` are written. WHIRL_NO_MEMORY.
whirl_status whirl_table_attractors(const whirl_table *table, size_t *labels, whirl_attractor *attractors, size_t most,
                                    size_t *count);

/// The attractors of all places of a table.
typedef struct whirl_coexistence {
    size_t places;           ///< of the table
    size_t attractors;       ///< that have a number of their own
    size_t count;            ///< of items
    whirl_coexisting *items; ///< [count] by place, then by number
    size_t *labels; ///< [table->count] the number of the attractor of every point; 0: not done, or without a verdict
} whirl_coexistence;

/// Tells apart the attractors that the starts of every place of a table lead to, as whirl_table_attractors does, and
/// gives them numbers along the study, 1 for the one that most starts of all places lead to. Attractors of neighbouring
/// places (along a sweep; along all axes of a map) have one number where each is the nearest of the other and
/// they differ by less than half of the larger one's extent: two periodic motions by the largest distance of a point of
/// one section from the nearest of the other, so that a motion goes on through a doubling of its period (but not where
/// neither period is a multiple of the other); others by
/// their means and bounds. Places where nothing has a verdict are passed over. No two of one place have one number. An
/// attractor that no start of a place in between met goes on under another number. Motions from neighbours are told
/// with the others, but count in no share. Needs the analyses "poincare" and "orbit". WHIRL_NO_MEMORY. Freed by
/// whirl_coexistence_free.
whirl_status whirl_table_coexistence(const whirl_table *table, whirl_coexistence *found);

/// Frees what was found; the struct itself is the caller's.
void whirl_coexistence_free(whirl_coexistence *found);

/// What a point of the table came to rest on; NULL where that is not told. Borrowed.
const whirl_coexisting *whirl_coexistence_at(const whirl_coexistence *found, const whirl_table *table, size_t point);

/// The share of the starts from which an attractor is missed by all `starts` of a place with a chance of one in twenty:
/// 1 - 0.05^(1/starts).
double whirl_missed_share(size_t starts);

/// A result in whose tables with several starts a place every attractor stands once: attractor by attractor along the
/// study, with the number in `branch`, and the block of the first start that came to rest on it; of a map the one
/// attractor of every place that most starts lead to. All else is borrowed from the result, which may itself be a view,
/// and has to live as long. WHIRL_NO_MEMORY. Freed by whirl_result_view_free.
whirl_status whirl_result_by_attractor(const whirl_result *result, whirl_result **view);

/// Frees a view and nothing that it borrowed; NULL is none.
void whirl_result_view_free(whirl_result *view);

/// A unit in which numbers are shown: `size` of it in SI. "" and 1 for plain numbers.
typedef struct whirl_unit {
    char name[WHIRL_NAME_SIZE]; ///< as it is written
    double size;                ///< of it in SI
} whirl_unit;

/// The unit in which the case (or --set) wrote a parameter: "rpm" of 2 pi/60 rad/s where it says "6000 rpm"; first the
/// one in which a sweep writes its values. An expression has the unit of the first parameter in it that is of its kind.
/// The SI unit where none is written, and for zeros; that of plain numbers for names that are no parameters.
whirl_unit whirl_result_unit(const whirl_result *result, const char *parameter);

/// The unit in which lengths of the result are best told: that in which the case wrote the parameter which is the
/// length scale, else m, mm or um by the length scale's size.
whirl_unit whirl_result_length_unit(const whirl_result *result);

/// What one unit of a field's numbers is in SI: of "length" and "force" the scales of the result, of revolutions and
/// orders what its clock says, of any other unit itself. NaN for lengths where the parameter of the table changes the
/// scale (whirl_result_length_scale), for revolutions and orders where it changes the clock (whirl_table_clock); a
/// table NULL has the scale and the clock of the result.
whirl_unit whirl_result_si(const whirl_result *result, const whirl_table *table, const char *unit);

/// The same of a field's numbers: of the second and third parameters of a map their own units.
whirl_unit whirl_field_si(const whirl_result *result, const whirl_table *table, const whirl_field *field);

/// The SI unit of a parameter, "1" of plain numbers and of what is no parameter. Borrowed.
const char *whirl_result_parameter_unit(const whirl_result *result, const char *parameter);

/// The options that the points of a table were computed with, group by group from 0: their members, and where in the
/// table the struct is that they are members of; NULL past the last group.
const whirl_member *whirl_table_options(const whirl_table *table, size_t group, size_t *offset);

/// The value of a fact, "" where there is none of that name. Borrowed.
const char *whirl_result_fact(const whirl_result *result, const char *name);

/// A warning that the result carries, by index from 0: values of the case that a law is not for or that no machine has,
/// ranges without extent. "" past the last. Borrowed.
const char *whirl_result_warning(const whirl_result *result, size_t index);

/// What stands in time for a bearing's table over the frequency of whirl, with its error, by index from 0. "" past the
/// last. Borrowed.
const char *whirl_result_fit(const whirl_result *result, size_t index);

/// A range of a law of the machine, by index from 0, as the rows of WHIRL_FIELD_RANGES_REACHED: "film at journal:
/// eccentricity ratio up to 0.95, to which its coefficients were found". "" past the last. Borrowed.
const char *whirl_result_law_range(const whirl_result *result, size_t index);

/// Appends the facts of this build and host: version, revision, compiler, flags, libraries, host, processor,
/// instruction set.
whirl_status whirl_result_add_provenance(whirl_result *result);

/// Whether two results are of the same case and study, with the same parameters: what either found does not matter.
/// When not, writes the first difference in at most `size` bytes ("line 5 of the case was 'a' and is 'b'"). Of a
/// partial file it cannot be told, for it has not all points.
bool whirl_result_same_study(const whirl_result *earlier, const whirl_result *later, char *difference, size_t size);

/// Writes every table as CSV files into the directory `path` (made when missing): one file with a line a point,
/// and one file a field that has rows. Units stand in the headings.
whirl_status whirl_result_export_csv(const whirl_result *result, const char *path);

/// Returns true where the export would replace a file, and writes the path of the first one in at most `size` bytes.
bool whirl_result_find_csv(const whirl_result *result, const char *path, char *found, size_t size);

/// Writes the result file `result` as a MAT file of version 5, compressed, which MATLAB and Octave load: a variable for
/// every group of the result file (docs/result-file.md), its numbers to the bit. `path` appears whole or not at all,
/// and replaces what is there. WHIRL_BAD_INPUT where `result` is damaged, WHIRL_IO_ERROR where either file fails or a
/// variable would have more than the 2 GB that such a file may hold.
whirl_status whirl_result_export_mat(const char *result, const char *path);

/// Writes the points as one JSON document ({"points": [...]}) as the user guide describes.
whirl_status whirl_result_write_json(const whirl_result *result, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
