/// Studies: which points are computed, on which threads.
///
/// A point is a pure function of (family, batch, index) and is written to its own slot, so the number of threads
/// changes no bit of a result.
#ifndef WHIRL_STUDY_H
#define WHIRL_STUDY_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/result.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How the starts of neighbouring points hang together.
typedef enum whirl_carry {
    WHIRL_CARRY_NONE = 0, ///< every point starts from its machine's start
    WHIRL_CARRY_FORWARD,  ///< the attractor is followed from the first value to the last
    WHIRL_CARRY_REVERSE,  ///< ... from the last to the first
    WHIRL_CARRY_BOTH      ///< both, as two branches: hysteresis shows
} whirl_carry;

/// A parameter that has another value than the case says.
typedef struct whirl_given {
    const char *name; ///< borrowed
    double value;     ///< in SI
} whirl_given;

/// The most parameters that all points of a batch have at other values, beside those that vary.
enum { WHIRL_MAX_GIVEN = 8 };

/// Points that are computed alike.
///
/// A batch with the analysis "trace" traces branches of orbits between bounds of its parameter, from `values` on: how
/// many points that gives is known when they are there. With a second parameter its points are those of curves through
/// the special points of the batch before it, whose parameter is the same; `values` are not looked at then. One with
/// the analysis "torus" follows the tori that begin at Neimark-Sacker points of the batch of that name, "branch".
///
/// A batch of a map has a second parameter, too, with a value at every point: the points of its rows follow each other.
/// With a third one it is a stack of such maps, plane after plane.
typedef struct whirl_batch {
    char name[WHIRL_NAME_SIZE];      ///< of its table, as whoever reads the result calls it
    whirl_role role;                 ///< of its points in the study
    char parameter[WHIRL_NAME_SIZE]; ///< what varies; "" for a single point
    size_t count;                    ///< of points
    const double *values;            ///< [count] of the parameter, in SI; borrowed; NULL when nothing varies
    double bounds[2];                ///< of the parameter, where branches are traced
    char second[WHIRL_NAME_SIZE];    ///< the second parameter of curves and maps, else ""
    const double *second_values;     ///< [count] of a map; borrowed; else NULL
    size_t row;                      ///< points of a row of a map, along the first parameter; else 0
    char third[WHIRL_NAME_SIZE];     ///< the third parameter of a map with planes, else ""
    const double *third_values;      ///< [count] of such a map; borrowed; else NULL
    size_t plane;                    ///< points of one of its planes; else 0
    /// Width of the first squares of a map that is refined, in points, a power of two: only their corners are computed,
    /// and what squares need that are halved where verdicts differ (whirl_table.refine); needs the analysis "regime",
    /// and one plane only.
    /// 0: all points are computed.
    size_t refine;
    double second_bounds[2];    ///< of the second parameter of curves
    size_t given_count;         ///< of given
    const whirl_given *given;   ///< [given_count] parameters that all machines have at these values; borrowed
    size_t placed_count;        ///< of placed, which whirl_study_place finds where its options ask for them
    const whirl_placed *placed; ///< [placed_count] unbalances in the place of the machine's own; borrowed
    double second_value;        ///< of the machine that is asked for; of the batch itself that of the case
    double third_value;         ///< the same of the third parameter of a map
    /// Starts of every point, 0 or 1 for that of its machine alone. The table has all points from the first start, then
    /// all from the next. Not of carried batches, nor of branches and machines at rest.
    size_t starts;
    /// Rounds, at most, in which every place is started, besides, from where motions of its neighbours (along a sweep;
    /// along all axes of a map) ended: one each on all attractors that none of its own motions has come to and
    /// from which it was not started before, up to WHIRL_MAX_NEIGHBOUR_STARTS in all. They end once no place lacks any.
    /// The table has these points after all others; they count in no share. 0: none. Only beside several starts.
    size_t neighbours;
    bool outline;          ///< the machine that is asked for is to be looked at (whirl_rotor_outline)
    double speed;          ///< of the machine that is asked for, rad/s; 0, and of the batch itself: its own
    bool asynchronous;     ///< coefficients over the frequency of whirl of the machine that is asked for are those at
    double frequency;      ///< rad/s, in place of that of the shaft
    double variant_value;  ///< of the variant that is asked for
    whirl_variant variant; ///< of it; of the batch itself that which is studied
    size_t start;          ///< which of them the machine shall have that is asked for, from 0; of the batch itself 0
    whirl_carry carry;     ///< whether points start where their neighbours end
    /// Every motion is computed once more from the same start with errors of a step 16 times smaller (twice the steps
    /// of a fixed-step method), and its verdict is set beside the first: needs the analysis "regime".
    bool confirm;
    whirl_integrate_options integrate; ///< by what method
    whirl_record_options record;       ///< what is recorded of each
    whirl_analysis_set analyses;       ///< what is said of each
    const whirl_room *room;            ///< NULL, or what large values lie in; borrowed
} whirl_batch;

/// The values [count] of a parameter of a batch, by axis from 0, along its points, and its name; NULL past the last. Of
/// a batch whose points are found its two bounds. Borrowed.
const double *whirl_batch_values(const whirl_batch *batch, size_t axis, const char **name, size_t *count);

/// Its members that are said of a study (part "study"); static, ended by one without a part.
const whirl_member *whirl_batch_members(void);

/// The most batches of a study.
enum { WHIRL_MAX_BATCHES = 32 };

/// Bounds of refined maps.
enum {
    WHIRL_MAX_SQUARE = 1024 ///< largest whirl_batch.refine
};

/// Bounds of refinement.
enum {
    WHIRL_MAX_ROUNDS = 6 ///< of refinement
};

/// What a run may spend on points whose verdict is in doubt: undetermined, or of low confidence. Such points are done
/// again from their own start as their verdict advises (whirl_advice_apply, its factor rounded up to a power of two),
/// the cheapest first, in up to WHIRL_MAX_ROUNDS rounds. All zero: nothing is spent.
typedef struct whirl_budget {
    /// Revolutions; those at n times the steps of the study count n times. Then no bit depends on how fast the computer
    /// is.
    double revolutions;
    double seconds; ///< ... or time; points that are not done within it are left as they were
} whirl_budget;

/// Batches of points of one family of machines.
typedef struct whirl_study {
    whirl_budget refine;                    ///< what may be spent on points in doubt
    size_t batch_count;                     ///< of batches
    whirl_batch batches[WHIRL_MAX_BATCHES]; ///< in the order in which they are computed
    /// Makes the machine for a value of the batch's parameter; called from several threads at once.
    /// All machines of a study have the same dimension, probes and contacts.
    whirl_status (*machine)(const void *family, const whirl_batch *batch, double value, whirl_machine *machine);
    const void *family; ///< borrowed
} whirl_study;

/// A share of a study for one of several runs that compute it together. Points are dealt out one by one, but carried
/// sweeps go whole, up and down each, and so do 8 neighbours at rest; all branches go to the first share. Of a refined
/// map first squares are dealt out; points on edges between two are of both shares, with the same bits.
typedef struct whirl_share {
    size_t number; ///< from 1 to count
    size_t count;  ///< 0: there are no shares
} whirl_share;

/// Whether a point, which a keeper knows by this batch and slot, is of a share, or may be where a map is refined; all
/// are where there are none.
bool whirl_share_has(const whirl_study *study, const whirl_share *share, size_t batch, size_t slot);

/// What a run is at. Every stage has points of its own.
typedef enum whirl_stage {
    WHIRL_STAGE_COMPUTE = 0, ///< the points of the study
    WHIRL_STAGE_CONFIRM,     ///< ... at the second tolerance; the revolutions of both stages are told together
    WHIRL_STAGE_NEIGHBOURS,  ///< starts from neighbours; every round has revolutions and seconds of its own
    WHIRL_STAGE_FOLLOW,      ///< copies of chaotic motions that may be on their way, with revolutions of their own
    WHIRL_STAGE_REFINE,      ///< points in doubt; every round has revolutions and seconds of its own
    WHIRL_STAGE_TABLES       ///< tables of films, before the points; points and revolutions are numbers of tables
} whirl_stage;

/// How far a run has come.
typedef struct whirl_progress {
    whirl_stage stage;                          ///< what it is at
    int round;                                  ///< of refinement, or of starts from neighbours, from 1; else 0
    size_t points_done, points_total;           ///< the total grows while a map is refined, and that of revolutions
    double revolutions_done, revolutions_total; ///< those at n times the steps of the study count n times
    double revolutions_recalled;                ///< of those done, what a keeper knew from an earlier run
    double seconds;                             ///< since the start
} whirl_progress;

/// The state of a point under way, after so many revolutions.
typedef struct whirl_kept_state {
    size_t batch, slot; ///< as a keeper knows the point
    double revolutions; ///< that are behind it
    const void *bytes;  ///< [size]
    size_t size;        ///< of the bytes
} whirl_kept_state;

/// Keeps finished points outside of a run, so that a later run of the same study can go on from them (a journal, see
/// whirl/engine/journal.h). A point is known by its batch and its slot in the batch's table. Where points are computed
/// more than once, `batch` tells the passes apart: it is the batch's index plus batch_count times the pass, which is
/// four times the round of refinement, one more at the second tolerance, two and three more for copies of chaotic
/// motions that are followed; there `block` is shorter. All functions are called by one thread at a time.
struct whirl_keeper {
    /// Takes a finished point: its block [size] and, in pass 0, the state [dimension] that a carried point starts from,
    /// all NaN where the motion diverged. An error ends the run.
    whirl_status (*keep)(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension);
    /// Asked before a point is computed. True when it is known: then block and end are filled, to the bit.
    bool (*recall)(void *context, size_t batch, size_t slot, double *block, size_t size, double *end, size_t dimension);
    /// Called a few times a second, so that what was kept may be brought to safety. May be NULL. An error ends the run.
    whirl_status (*tend)(void *context);
    void *context; ///< handed to every function; borrowed
    /// Takes the states of the motions that thread `worker` has under way, in place of those that it gave before: so
    /// that long points need not begin anew. Called every few seconds. May be NULL. What cannot be kept is no error.
    void (*save)(void *context, size_t worker, const whirl_kept_state *states, size_t count);
    /// Asked when a point is begun: the state furthest on that was saved of it, to be freed by free, or NULL.
    void *(*saved)(void *context, size_t batch, size_t slot, double *revolutions, size_t *size);
};

/// Deals out the points of a study among several runs that compute it together, at the same time and each with a keeper
/// of its own. Points are dealt in pieces: a point and its confirmation one by one, carried sweeps whole, up and down
/// each, and confirmed where they were followed, neighbours at rest by eights. Branches and tori are not dealt: the run
/// that gathers traces them. No bit of a result depends on who computes what. `open` and `claim` are called by one
/// thread at a time.
typedef struct whirl_dealer {
    int threads; ///< of all runs together
    /// Whether a point, which a keeper knows by this batch and slot, is to be computed by one of the runs: all but what
    /// was known before they began. The same in all runs, at any time.
    bool (*open)(void *context, size_t batch, size_t slot);
    /// Takes those that come next of the `count` pieces of a pass, which a keeper knows by this batch. Gives how many,
    /// from *first on; 0: all are taken.
    size_t (*claim)(void *context, size_t batch, size_t count, size_t *first);
    /// Called in the run that gathers when it has nothing more to compute, or was stopped: waits until the others have
    /// ended, and lets its keeper know what theirs do. The run then takes all points from there, whether it was stopped
    /// or not, and goes on with what needs them all. An error ends the run. NULL: another run gathers, and this one
    /// ends with its points and a partial result.
    whirl_status (*gather)(void *context);
    void *context; ///< handed to every function; borrowed
} whirl_dealer;

/// How a study is run. All zero: on all cores, silently.
typedef struct whirl_run_options {
    int threads; ///< 0: all cores
    /// Called a few times a second from one thread at a time, and at the end. May be NULL.
    void (*progress)(void *context, const whirl_progress *progress);
    void *context;              ///< handed to progress; borrowed
    const whirl_stop *stop;     ///< NULL, or becomes true when the run shall end early
    const whirl_keeper *keeper; ///< NULL: every point is computed
    /// Bytes of a table's blocks from which on they are left with the keeper, if there is one, which must then live as
    /// long as the result; 0: 256 MB. Not where points are confirmed or refined: their blocks stay in memory.
    size_t memory;
    /// The points that are computed, and confirmed; the others are not asked for. The run ends with that, for to follow
    /// and to refine all points are needed. Its result is partial. All zero: all points.
    whirl_share share;
    /// Points and their confirmations are taken from the keeper and not computed: WHIRL_STOPPED where one is missing.
    /// Branches that were begun are traced to their end; with all points there, what needs them all is computed.
    bool gather;
    const whirl_dealer *dealer; ///< NULL: all points are this run's, or its share
} whirl_run_options;

/// Finds the unbalances by rule (whirl_record_options.antinodes_of, placed_at) that a batch asks for, and gives them to
/// it: of the machine as its parameters are without what varies, at the largest running speed. *placed is what the
/// batch borrows, to be freed by free; NULL where it asks for none or has them. Runs do it by themselves.
/// WHIRL_BAD_INPUT with a sentence where the machine has no such mode or station; WHIRL_NO_MEMORY.
whirl_status whirl_study_place(const whirl_study *study, whirl_batch *batch, whirl_placed **placed);

/// The machine of a point of a batch, by its index in `values` (0 where nothing varies); from start s that of the index
/// plus s times the count; that of a start from a neighbour has the first start. Errors as those of study->machine.
whirl_status whirl_study_machine(const whirl_study *study, const whirl_batch *batch, size_t point,
                                 whirl_machine *machine);

/// Puts a method in the place of "auto" in every batch that asks for it: dop853, or rodas5p where whirl_method_probe,
/// at the first, the middle and the last value of the parameter, counts less work in all. All points of a batch go by
/// one method. The choice is a pure function of the study. Runs, outlines and verifications do it by themselves. Errors
/// as those of the machines.
whirl_status whirl_study_choose_methods(whirl_study *study);

/// Bounds of starts.
enum {
    WHIRL_MAX_STARTS = 65536, ///< of a point
    WHIRL_MAX_RANGES = 32     ///< coordinates in which starts may differ
};

/// A number of the sequence of Halton (Numerische Mathematik 2, 1960, eq. 1): the digits of `index` in base p mirrored
/// at the point, where p is prime number `coordinate` (0: 2, 1: 3, ..., below WHIRL_MAX_RANGES). From 0 to 1; several
/// coordinates of rising indices fill their cube evenly.
double whirl_halton(size_t index, size_t coordinate);

/// How orbits along the branches of a batch that traces them are found. A method "auto" is to be settled before.
whirl_orbit_options whirl_batch_orbits(const whirl_batch *batch);

/// Revolutions of all points without refinement, as a budget counts them: at n times the steps of the study n times. Of
/// a refined map the corners of its first squares count, which are all that is known before it runs; starts from
/// neighbours count none.
double whirl_study_revolutions(const whirl_study *study);

/// The result of a study before any point is computed: its tables without blocks, and the film tables that
/// whirl_study_prepare has made (whirl_result_film_tables). The rest of it is empty (see whirl_case_describe_result).
/// Freed by whirl_result_free.
whirl_status whirl_study_outline(const whirl_study *study, whirl_result **outline);

/// Makes the tables of films that a study needs for its first points, on options->threads, with progress. Runs do it by
/// themselves; who wants an outline before, whose methods are to be chosen, calls it to be told and stopped meanwhile.
/// WHIRL_STOPPED, WHIRL_NO_MEMORY.
whirl_status whirl_study_prepare(const whirl_study *study, const whirl_run_options *options);

/// Runs all batches. `result` gets one table a batch; the rest of it is empty (see whirl_case_describe_result).
/// The first error of a point ends the run, without a result. WHIRL_STOPPED when stopped before the last point, or
/// before the last one was confirmed or refined: then there is a result too, of the points that are done
/// (whirl_table_done); the numbers of the others are NaN; without a result where it was stopped in whirl_study_prepare.
/// WHIRL_NO_MEMORY where memory ran out anywhere: no number depends on how much there was. With a budget the blocks
/// have the fields "refine/...": rounds, what was spent, and the options that count at last. No bit of a result depends
/// on which points a keeper knew. The result is freed by whirl_result_free.
whirl_status whirl_study_run(const whirl_study *study, const whirl_run_options *options, whirl_result **result);

#ifdef __cplusplus
}
#endif
#endif
