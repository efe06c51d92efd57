/// Views of tables whose points are not motions: one file for each kind in this folder, one line in the registry.
/// Tables of motions are shown by summary, figures and pages.
#ifndef REPORT_SHOWN_KINDS_H
#define REPORT_SHOWN_KINDS_H

#include "findings_build.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"
#include "whirl/engine/spread.h"
#include "whirl/internal/model.h"

typedef struct shown_kind {
    const char *field;         ///< field that only its tables have
    const char *anchor, *name; ///< anchor and name of its section
    const char *about;         ///< introduction to all sections of the kind, written once; NULL: none
    const char *held; ///< how its numbers treat closed contacts, a clause; NULL: small motions leave them as they are
    void (*find)(const finder *of); ///< finds the findings of a table
} shown_kind;

/// Returns the kind of a table; NULL for motions.
const shown_kind *shown_kind_of(const whirl_table *table);

/// Finds the weight, the shafts, stations, bearings and other parts of the machine.
void find_machine(const finder *of);

/// Finds the bearings, seals, dampers, magnets and supports.
void find_bearings(const finder *of, const whirl_model *model);

/// Finds the spread of a number over the samples of a table, and what parameters cause of it: the sheets "spread" and
/// "indices".
void find_spread_of(const finder *of, const whirl_spread_of *number);

/// Finds the inertias and joints of stations that twist.
void find_train(const finder *of, const whirl_model *model);

/// Finds spectral lines of motions along a parameter, below and above the synchronous one.
void find_lines(const finder *of);

/// Returns the stability of the modes at a point: 1 if one grows, -1 if all decay, 0 if the largest growth is rounding.
int shown_modes_growing(const whirl_table *table, size_t point);

// clang-format off
/// The kinds. The kind of a table is the first one whose field it has.
#define SHOWN_KINDS(kind)                                                                                              \
    kind(tolerances) kind(branches) kind(tori) kind(modes) kind(unbalance) kind(critical_speeds) kind(stability)       \
    kind(statics) kind(runup) kind(twists) kind(fit) kind(records)
// clang-format on
#define SHOWN_KIND(name) extern const shown_kind shown_##name;
SHOWN_KINDS(SHOWN_KIND)

/// Returns a fact of a data set, such as "label" 2, in parts: its name, and the rest behind the colon ("" for none).
const char *records_fact(const whirl_result *result, const char *what, size_t number, char name[WHIRL_NAME_SIZE]);

/// Returns the largest share of the time that a contact is closed in a record; NaN for a machine without contacts.
double records_contact(const whirl_result *result, const whirl_table *table, size_t point);

/// Returns the point of a table of fits with the least sum of squares; the number of points if there is none.
size_t fit_best(const whirl_table *table);

/// Writes the name of a measured quantity by its row of the field fit/number: "disc x", "disc 45 deg 2X".
void fit_name_probe(const whirl_result *result, const double *row, char *name, size_t size);

/// Finds torsional modes in a table of modes: their excitations, separations and shapes.
void find_torsion(const finder *of);

/// An excitation of torsion: so many times the speed of the shaft, or so many times the frequency of the line.
typedef struct torsion_excitation {
    int order;
    bool line;
} torsion_excitation;

/// Returns the number of excitations of a table: its orders, then the frequency of the line and twice that, if any.
int torsion_excitation_count(const whirl_table *table);
torsion_excitation torsion_excitation_at(const whirl_table *table, int index);

/// Returns the frequency of an excitation at a speed, both in rad/s.
double torsion_excitation_frequency(const whirl_table *table, torsion_excitation by, double speed);

/// Writes the name of a torque by its row of the fields runup/torque_of and torsion/torque_of: "motor to load",
/// "induction motor at motor", "mesh of wheel and pinion".
void torque_name(const whirl_result *result, const double *of, char *name, size_t size);

/// Writes the name of an excitation of a response to torques: "2X", "100 Hz".
void twists_name_excitation(const whirl_table *table, size_t index, char *name, size_t size);

/// Chooses the torques of a response with the largest sums, at most `most`, in falling order; returns how many.
size_t twists_choose(const whirl_table *table, size_t most, size_t *chosen);

/// Returns true for a mode with more than half of its kinetic energy in twists.
bool mode_is_torsional(const whirl_table *table, size_t point, size_t mode);

/// Returns true for a mode with a damping ratio above WHIRL_OVERDAMPED_RATIO.
bool mode_is_overdamped(const whirl_table *table, size_t point, size_t mode);

// ---------------------------------------------------------------- spread_words
// Numbers whose spread over samples is shown (whirl/engine/spread.h).

enum { SPREAD_NAME = 5 * WHIRL_NAME_SIZE, SPREAD_VERDICTS = 32 };

/// Writes the name of a number: "major of unbalance axes at disc".
void spread_name(const whirl_table *table, const whirl_spread_of *of, char text[SPREAD_NAME]);

/// Returns the unit in which it is shown: shown number = number in SI over its size.
whirl_unit spread_unit(const whirl_shown_units *units, const whirl_table *table, const whirl_spread_of *of);

/// Lists the different verdicts of a table, in the order of their first points; returns how many.
size_t spread_verdicts(const whirl_table *table, whirl_verdict verdicts[SPREAD_VERDICTS]);

// ---------------------------------------------------------------- mode_lines
// Modes followed from point to point along a parameter, each with a name.

/// Name of a line of modes, "2F": the second forward one by frequency at its last point; B: backward, M: mixed, to and
/// fro; T: torsional. Lines that reach the last point count first. Overdamped modes have no name and no line.
enum { MODE_NAME = 24 };

typedef struct mode_lines {
    size_t count, modes;      ///< lines, and modes of a point
    size_t *line;             ///< [points][modes] line of each mode; SIZE_MAX: none
    char (*names)[MODE_NAME]; ///< [count]
} mode_lines;

/// mode_lines_of: follows the modes of a table; free with mode_lines_free. Returns false, with nothing to free, if
/// modes were not followed, and without memory.
bool mode_lines_of(const whirl_table *table, mode_lines *out);
void mode_lines_free(mode_lines *lines);

/// Returns the name of a mode at a point; "" if it is on no line.
const char *mode_lines_name(const mode_lines *lines, size_t point, size_t mode);

// ---------------------------------------------------------------- asked
// Acceptance criteria after API 617, the values found, and the verdicts; all renderers use them. The user has to check
// which edition applies.

enum { ASKED_TEXT = 320 };

/// Returns the required logarithmic decrement.
extern const double asked_decrement;

/// Stability at a point. Numbers that were not found are NaN.
typedef struct asked_stability {
    bool stages;               ///< cross coupling is anticipated, so that there is a Level I
    double anticipated, limit; ///< cross coupling, N/m; a limit of NaN: at no less than 1000 times the anticipated
    double ratio, factor;      ///< limit over anticipated, and its required value: 10 in region B, else 2
    double region;             ///< region of the screening diagram: 0: A, 1: B
    double decrement;          ///< least decrement with bearings and stages
    double complete;           ///< least decrement with seals and impellers too
    whirl_judgement level_one; ///< for bearings and stages; WHIRL_NOT_ASKED without stages
    bool decides;              ///< seals and impellers are to be counted (Level II): Level I does not hold
    whirl_judgement level_two; ///< for the whole machine: the verdict of the point
} asked_stability;

asked_stability asked_stability_at(const whirl_table *table, size_t point);

/// Writes "decrement above 0.1 and limit above 2 times the anticipated: holds by Level I".
void asked_stability_text(const asked_stability *at, char text[ASKED_TEXT]);

/// Stability at all points of a table.
typedef struct asked_stability_tally {
    size_t points, without; ///< done points, and those of them whose modes are all backward
    size_t screened, dense; ///< points in the screening diagram, and in its region B
    asked_stability
        least; ///< point of least decrement with seals and impellers; its decrement is NaN if no point has one
    asked_stability coupled; ///< point at which the limit of the cross coupling fails most; none without stages
    double decrement;        ///< the least with bearings and stages, of points with stages
    whirl_judgement level_one, level_two;
} asked_stability_tally;

asked_stability_tally asked_stability_count(const whirl_table *table);

/// Judges a response with running speeds: margins, vibration, clearances.
void ask_response(const finder *of);

/// Judges the stability at all points of a table.
void ask_stability(const finder *of);

// ---------------------------------------------------------------- margins
// Critical speeds as peaks of a response to unbalance, and their margins.

enum { MARGIN_PEAKS = 32, MARGIN_TEXT = 160 };

/// Finds the running speeds, rad/s; a single speed is both. Returns false if none is given.
bool margin_running(const whirl_table *table, double *low, double *high);

/// Returns true if margins and clearances are required: the table gives running speeds.
bool margin_asked(const whirl_table *table);

/// Returns true if margins are required of a station's peaks: it is one of probes_at, or probes_at is not given.
bool margin_probed(const whirl_result *result, const whirl_table *table, size_t station);

/// Reason why peaks may have been missed: points along another parameter, or not over all running speeds; NULL if none.
const char *margin_lacks(const whirl_table *table);

/// A peak, and its required margin.
typedef struct margin_row {
    double probe;          ///< its angle, degrees
    double speed;          ///< rad/s
    double amplitude;      ///< m, zero to peak
    double amplification;  ///< factor
    char way[MARGIN_TEXT]; ///< "half power", ...; "half power, of 1.2 points: compute more there"
    bool judged, holds;    ///< margin required; margin met (holds)
    double had, asked;     ///< margins in %; NaN without running speeds or probe, or within these speeds
    const char *side;      ///< "above", "below" or "within" the running speeds; "" without these
    const char *verdict;   ///< "holds", "not judged: no probe", ...; "" without running speeds
} margin_row;

/// Gathers speed, amplitude in m and lag [points of the table] at probe 0 or 1 of a station. Returns their number, 0 if
/// speeds do not rise along the table.
size_t margin_response(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                       double *speeds, double *sizes, double *lags);

/// Finds the peaks at both probes of a station; none if speeds do not rise along the table, or there are too few
/// points.
size_t margin_rows(const whirl_result *result, const whirl_table *table, size_t station,
                   margin_row rows[2 * MARGIN_PEAKS]);

/// All peaks of a response with a required margin. `verdict` applies to the response: unknown if all known peaks have
/// their margin, but others may have been missed.
typedef struct margin_tally {
    whirl_judgement verdict;
    const char *lacks; ///< reason why peaks may have been missed (margin_lacks); NULL: none, or nothing is required
    size_t judged, held;
    size_t unjudged;  ///< peaks with amplification of 2.5 or more at stations outside probes_at
    margin_row worst; ///< peak with the largest deficit or, if none has one, the least surplus
    double more;      ///< surplus of that peak, %; minus infinity within the running speeds
    size_t station;   ///< station of that peak
} margin_tally;

margin_tally margin_count(const whirl_result *result, const whirl_table *table);

// ---------------------------------------------------------------- scaled
// Responses to unbalance scaled to the vibration limit, and what they take of clearances (after API 617: which edition
// counts is for the user to check).

/// The scale of a table's responses: lengths in m peak to peak.
typedef struct scaled {
    double limit;   ///< vibration limit, min(25.4, 25.4 sqrt(12000/N)) um, N rpm the highest running speed
    double largest; ///< largest response at any probe between the running speeds
    size_t station; ///< station of the largest response
    double factor;  ///< limit over largest, 6 at most
    bool beyond;    ///< the largest response exceeds the limit: the factor is below 1
    double trip;    ///< rad/s, highest speed at which clearances are checked; 0: not given, all speeds
    bool reaches;   ///< points reach beyond the trip speed
} scaled;

/// Scaled response of a station compared with its clearance.
typedef struct scaled_row {
    size_t station;
    double axis;      ///< m, the largest scaled major axis at any point, peak to peak
    double speed;     ///< rad/s, at that axis
    double clearance; ///< m, diametral clearance there
    bool holds;       ///< the axis is at most 75 % of the clearance
} scaled_row;

/// Returns true for the stations that are checked: those with probes (probes_at), a clearance or an unbalance by rule;
/// all stations if probes_at is not given.
bool scaled_watches(const whirl_result *result, const whirl_table *table, size_t station);

/// Returns the reason for a failure of scaled_of in a table with running speeds.
extern const char *const scaled_lacks;

/// Finds the scale of a table's responses. Returns false if the table gives no running speeds, or its points do not
/// cover them.
bool scaled_of(const whirl_result *result, const whirl_table *table, scaled *out);

/// Fills rows [station count] for all stations with a clearance; returns how many.
size_t scaled_rows(const whirl_result *result, const whirl_table *table, const scaled *by, scaled_row *rows);

/// Finds the first of the rows with the largest share of its clearance. Returns false if there is none.
bool scaled_tightest(const whirl_result *result, const whirl_table *table, const scaled *by, scaled_row *row);

#endif
