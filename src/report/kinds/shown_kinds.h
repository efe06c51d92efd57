/// How tables are shown whose points are no motions: one file a kind in this folder, one line in the registry. Tables
/// of motions are what summary, figures and pages themselves are about.
#ifndef REPORT_SHOWN_KINDS_H
#define REPORT_SHOWN_KINDS_H

#include "findings_build.h"
#include "report_parts.h"
#include "whirl/engine/result.h"
#include "whirl/engine/shown.h"

typedef struct shown_kind {
    const char *field;         ///< which its tables have, and no others
    const char *anchor, *name; ///< of its section
    const char *about;         ///< what all of its sections share, told once; NULL: nothing
    const char *held; ///< what its numbers do with contacts at rest; NULL: small motions leave them as they are
    void (*find)(const finder *of); ///< what is found in a table of it
} shown_kind;

/// That of a table, NULL of motions.
const shown_kind *shown_kind_of(const whirl_table *table);

/// Of motions along a parameter: lines of their spectra below and above the synchronous one.
void find_lines(const finder *of);

/// Of modes at a point: 1 where one grows, -1 where all die out, 0 where they do neither but for rounding.
int shown_modes_growing(const whirl_table *table, size_t point);

extern const shown_kind shown_branches, shown_tori, shown_modes, shown_unbalance, shown_critical_speeds,
    shown_stability, shown_statics;

/// Returns true for a mode with a damping ratio above WHIRL_OVERDAMPED_RATIO.
bool mode_is_overdamped(const whirl_table *table, size_t point, size_t mode);

// ---------------------------------------------------------------- mode_lines
// Modes followed from point to point along a parameter, each with a name.

/// "2F": the second of those that go forward where they were seen last, by rising frequency; B: backward, M: mixed, to
/// and fro. Those that go on to the last point count first. Overdamped modes have no name and are on no line.
enum { MODE_NAME = 24 };

typedef struct mode_lines {
    size_t count, modes;      ///< lines, and modes of a point
    size_t *line;             ///< [points][modes] which line each is of, SIZE_MAX of none
    char (*names)[MODE_NAME]; ///< [count]
} mode_lines;

/// To be freed. False, with nothing to free, of a table whose modes were not followed, and without memory.
bool mode_lines_of(const whirl_table *table, mode_lines *out);
void mode_lines_free(mode_lines *lines);

/// Of a mode of a point; "" of none, and where there are no lines.
const char *mode_lines_name(const mode_lines *lines, size_t point, size_t mode);

// ---------------------------------------------------------------- asked
// What is asked of a machine, what was found, and whether it holds: the one place that all who tell it ask. After API
// 617; which edition counts is for the user to check.

enum { ASKED_TEXT = 320 };

/// The logarithmic decrement that is asked for.
extern const double asked_decrement;

/// Stability at a point. Numbers that were not found are NaN.
typedef struct asked_stability {
    bool stages;               ///< cross coupling is anticipated, so that there is a Level I
    double anticipated, limit; ///< cross coupling, N/m; a limit of NaN: at no less than 1000 times the anticipated
    double ratio, factor;      ///< limit over anticipated, and what is asked of it: 10 in region B, else 2
    double region;             ///< of the screening diagram: 0: A, 1: B
    double decrement;          ///< with bearings and stages
    double complete;           ///< with seals and impellers, too
    whirl_judgement level_one; ///< of bearings and stages; WHIRL_NOT_ASKED without stages
    bool decides;              ///< seals and impellers are to be counted (Level II): Level I does not hold
    whirl_judgement level_two; ///< of the whole machine: the verdict of the point
} asked_stability;

asked_stability asked_stability_at(const whirl_table *table, size_t point);

/// "decrement above 0.1 and limit above 2 times the anticipated: holds by Level I".
void asked_stability_told(const asked_stability *at, char text[ASKED_TEXT]);

/// Stability at all points of a table.
typedef struct asked_stability_tally {
    size_t points, without;  ///< that are done, and those without a mode that does not go backward
    size_t screened, dense;  ///< in the screening diagram, and in its region B
    asked_stability least;   ///< of the least decrement with seals and impellers; that is NaN where no point has one
    asked_stability coupled; ///< where the limit of the cross coupling lacks most; without stages: none
    double decrement;        ///< the least with bearings and stages, of points with stages
    whirl_judgement level_one, level_two;
} asked_stability_tally;

asked_stability_tally asked_stability_count(const whirl_table *table);

/// What is asked of a response that tells running speeds: margins, vibration, clearances.
void ask_response(const finder *of);

/// What is asked of stability.
void ask_stability(const finder *of);

// ---------------------------------------------------------------- margins
// Critical speeds as peaks of a response to unbalance, and their margins.

enum { MARGIN_PEAKS = 32, MARGIN_TEXT = 160 };

/// The speeds between which a machine runs, rad/s; one that is said alone is both. False where none is said.
bool margin_running(const whirl_table *table, double *low, double *high);

/// Whether margins and clearances are asked for: a table tells running speeds.
bool margin_asked(const whirl_table *table);

/// Whether margins are asked of the peaks of a station: it is one of probes_at, or these are not said.
bool margin_probed(const whirl_result *result, const whirl_table *table, size_t station);

/// Why peaks of a response that tells running speeds may have escaped: its points lie along another parameter, or do
/// not reach over these speeds; NULL where they do.
const char *margin_lacks(const whirl_table *table);

/// A peak, and what is asked of it.
typedef struct margin_row {
    double probe;          ///< its angle, degrees
    double speed;          ///< rad/s
    double amplitude;      ///< m, zero to peak
    double amplification;  ///< factor
    char way[MARGIN_TEXT]; ///< "half power", ...; "half power, of 1.2 points: compute more there"
    bool told, holds;      ///< whether a margin is asked for, and had
    double had, asked;     ///< margins in %; NaN where running speeds are not said, there is no probe, or the peak is
                           ///< within these speeds
    const char *side;      ///< "above", "below" or "within" the running speeds; "" where these are not said
    const char *verdict;   ///< "holds", "at none of probes_at: not judged", ...; "" where running speeds are not said
} margin_row;

/// Speed, amplitude in m and lag [points of the table] that probe 0 or 1 of a station sees; how many, 0 where speeds do
/// not rise along the table.
size_t margin_response(const whirl_result *result, const whirl_table *table, size_t station, size_t probe,
                       double *speeds, double *sizes, double *lags);

/// The peaks that both probes of a station see; none where speeds do not rise along the table, or too few points are
/// there.
size_t margin_rows(const whirl_result *result, const whirl_table *table, size_t station,
                   margin_row rows[2 * MARGIN_PEAKS]);

/// All peaks of a response of which a margin is asked for. `verdict` is that of the response: where all peaks that were
/// found have their margin but others may have escaped, it is not known.
typedef struct margin_tally {
    whirl_judgement verdict;
    const char *lacks; ///< why peaks may have escaped (margin_lacks); NULL: none has, or nothing is asked for
    size_t told, held;
    size_t unjudged;  ///< peaks of an amplification of 2.5 or more at stations that are none of probes_at
    margin_row worst; ///< the first that lacks most of its margin or, where none does, has least more than that
    double more;      ///< what that one has more than is asked for, %; minus infinity within the running speeds
    size_t station;   ///< of that one
} margin_tally;

margin_tally margin_count(const whirl_result *result, const whirl_table *table);

// ---------------------------------------------------------------- scaled
// Responses to unbalance scaled to the vibration limit, and what they take of clearances (after API 617: which edition
// counts is for the user to check).

/// The scale of a table's responses: lengths in m peak to peak.
typedef struct scaled {
    double limit;   ///< of vibration, min(25.4, 25.4 sqrt(12000/N)) um, N rpm the highest running speed
    double largest; ///< that any of the probes sees between the running speeds
    size_t station; ///< at which
    double factor;  ///< limit over largest, 6 at most
    bool beyond;    ///< the largest is beyond the limit: the factor is below 1
    double trip;    ///< rad/s, up to which clearances are looked at; 0: not said, at all speeds
    bool reaches;   ///< points reach over the trip speed
} scaled;

/// What the response takes of a station's clearance.
typedef struct scaled_row {
    size_t station;
    double axis;      ///< m, the largest scaled major axis at any point, peak to peak
    double speed;     ///< rad/s, where
    double clearance; ///< m, the diametral one there
    bool holds;       ///< the axis is at most 75 % of it
} scaled_row;

/// Whether a station is one that engineers look at: with probes, where these are said (probes_at), a clearance or an
/// unbalance by rule; all where probes are not said.
bool scaled_watches(const whirl_result *result, const whirl_table *table, size_t station);

/// What a table that tells running speeds lacks where scaled_of fails.
extern const char *const scaled_lacks;

/// False where the table does not tell running speeds, or its points do not reach over them.
bool scaled_of(const whirl_result *result, const whirl_table *table, scaled *out);

/// Rows [station count] of all stations with a clearance; how many.
size_t scaled_rows(const whirl_result *result, const whirl_table *table, const scaled *by, scaled_row *rows);

/// The first of these that takes most of its clearance; false where there is none.
bool scaled_tightest(const whirl_result *result, const whirl_table *table, const scaled *by, scaled_row *row);

#endif
