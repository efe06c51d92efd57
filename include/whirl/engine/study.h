/// Studies: the points of batches, computed on threads.
///
/// A point is a pure function of (family, batch, index) and is written to its own slot, so that the number of threads
/// changes no bit of a result.
#ifndef WHIRL_STUDY_H
#define WHIRL_STUDY_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/dataset.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/result.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/system.h"
#include "whirl/engine/tolerances.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Starts of neighbouring points.
typedef enum whirl_carry {
    WHIRL_CARRY_NONE = 0, ///< every point starts from its machine's start
    WHIRL_CARRY_FORWARD,  ///< follow the attractor from the first value to the last
    WHIRL_CARRY_REVERSE,  ///< follow it from the last value to the first
    WHIRL_CARRY_BOTH      ///< both, as two branches, which shows hysteresis
} whirl_carry;

/// A parameter with another value than in the case.
typedef struct whirl_given {
    const char *name; ///< borrowed
    double value;     ///< in SI
} whirl_given;

/// Maximum number of parameters that all points of a batch have at other values than the case.
enum { WHIRL_MAX_GIVEN = 48 };

/// A batch: points with the same options.
///
/// A batch with the analysis "trace" follows branches of orbits between bounds of its parameter, from `values` on; the
/// number of its points is known at the end. With a second parameter it follows curves through the special points of
/// the preceding batch, which has the same parameter, and ignores `values`. A batch with the analysis "torus" follows
/// the tori that begin at Neimark-Sacker points of the batch named "branch".
///
/// A batch of a map has a second parameter with a value at every point, stored row by row; with a third parameter it is
/// a stack of such maps, stored plane by plane. A batch is also the request for a machine: whirl_study.machine receives
/// a copy of it whose members marked "requested machine" select one machine.
typedef struct whirl_batch {
    char name[WHIRL_NAME_SIZE];      ///< name of its table in results
    whirl_role role;                 ///< role of its points in the study
    char parameter[WHIRL_NAME_SIZE]; ///< the varied parameter; "" for a single point
    size_t count;                    ///< number of points
    const double *values;            ///< [count] the parameter, in SI; borrowed; NULL if nothing varies
    double bounds[2];                ///< range of the parameter for branches
    char second[WHIRL_NAME_SIZE];    ///< the second parameter of curves and maps, else ""
    const double *second_values;     ///< [count] for a map; borrowed; else NULL
    size_t row;                      ///< points of a row of a map, along the first parameter; else 0
    char third[WHIRL_NAME_SIZE];     ///< the third parameter of a map with planes, else ""
    const double *third_values;      ///< [count] for a map with planes; borrowed; else NULL
    size_t plane;                    ///< points of a plane of that map; else 0
    /// Width of the first squares of a refined map, in points, a power of two; 0: all points are computed. Only corners
    /// of squares are computed; squares whose verdicts differ are halved (whirl_table.refine). Needs the analysis
    /// "regime", and one plane.
    size_t refine;
    double second_bounds[2];  ///< range of the second parameter of curves
    size_t given_count;       ///< number of given parameters
    const whirl_given *given; ///< [given_count] parameters that all machines have at these values; borrowed
    size_t happened_count;    ///< requested machine: number of events of its run that have happened; else 0
    unsigned char happened[WHIRL_MAX_EVENTS]; ///< [happened_count] indices of these events in whirl_run_course.events,
                                              ///< in their order
    size_t placed_count; ///< number of placed unbalances, which whirl_study_place finds if the options ask for them
    const whirl_placed *placed; ///< [placed_count] unbalances that replace the machine's own; borrowed
    double second_value;        ///< requested machine: second parameter; in the batch itself the value of the case
    double third_value;         ///< requested machine: third parameter of a map
    /// Starts for each parameter value, 0 or 1 for that of the machine only. The table has all points with the first
    /// start, then all with the next. Not for carried batches, branches and machines at rest.
    size_t starts;
    /// Maximum number of rounds of starts from neighbours (along a sweep; along all axes of a map), in addition to
    /// several starts; 0: none. If a motion of a neighbour is on an attractor that no motion of the parameter value
    /// reached, the value starts once from the end of that motion. A value has up to WHIRL_MAX_NEIGHBOUR_STARTS such
    /// starts in all. The rounds end when no value has such a start left. These points follow all others in the table,
    /// and count in no share.
    size_t neighbours;
    /// A study of tolerances: `count` is the number of points of all machines of all samples, `row` points for each
    /// machine; 0 samples: no such study.
    whirl_tolerance_options tolerances;
    const whirl_tolerance *tolerated; ///< [tolerances.parameters] the parameters with tolerances; borrowed
    const whirl_dataset *dataset;     ///< data set, each of whose records is a point; borrowed; NULL: none
    size_t fit_run;                   ///< requested machine: 1 + entry of the fit's data whose run it makes; 0: none
    /// Requested machine: 1 + index of the machine among those of samples, or of the record; 0: none.
    size_t sampled;
    bool outline;                          ///< requested machine: an outline (whirl_rotor_outline)
    double speed;                          ///< requested machine: speed, rad/s; 0, and in the batch itself: its own
    size_t spool_count;                    ///< requested machine: number of speeds below; 0: those of the keys
    double spool_speeds[WHIRL_MAX_SPOOLS]; ///< [spool_count] rad/s of the shafts with a speed of their own, along their
                                           ///< rotations; more than there are shafts are ignored
    bool spools_vary;                      ///< requested machine: true if these speeds change while it runs
    bool asynchronous;                     ///< true if the requested machine has its coefficients at `frequency`
    double frequency;      ///< frequency of whirl, rad/s, at which coefficients are taken instead of at the shaft's
                           ///< speed
    double variant_value;  ///< requested machine: value of its variant
    whirl_variant variant; ///< requested machine: its variant; in the batch itself the studied one
    size_t start;          ///< requested machine: index of its start, from 0; in the batch itself 0
    whirl_carry carry;     ///< use of the ends of neighbouring motions as starts
    /// Compute every motion again from the same start with errors of a step 16 times smaller (twice the steps of a
    /// fixed-step method), to confirm its verdict. Needs the analysis "regime".
    bool confirm;
    whirl_integrate_options integrate;           ///< method of the motions
    whirl_record_options record;                 ///< contents of the records
    whirl_analysis_set analyses;                 ///< analyses of the points
    const struct whirl_derivatives *derivatives; ///< derivatives of every point's numbers; borrowed; NULL: none
    const whirl_fit *fit;                        ///< fit of parameters to measured numbers; borrowed; NULL: none
    const whirl_mapped *mapped;                  ///< NULL, or memory of large `values`; borrowed
    /// Requested machine: the flag that ends its motions (whirl_system.stop), and the making of its film tables. NULL
    /// in the batch itself, since runs set the flag of their options. Borrowed.
    const whirl_stop *stop;
} whirl_batch;

/// Returns the values [count] of a parameter of a batch along its points, by axis from 0, and its name; NULL past the
/// last. For branches its two bounds. Borrowed.
const double *whirl_batch_values(const whirl_batch *batch, size_t axis, const char **name, size_t *count);

/// Returns the members of a batch for cases (part "study"); static, ended by a member without a part.
const whirl_member *whirl_batch_members(void);

/// Maximum number of batches of a study.
enum { WHIRL_MAX_BATCHES = 32 };

/// Limits of refined maps.
enum {
    WHIRL_MAX_SQUARE = 1024 ///< largest whirl_batch.refine
};

/// Limits of refinement.
enum {
    WHIRL_MAX_ROUNDS = 6 ///< rounds of refinement
};

/// Budget of a run for points whose verdict is in doubt: undetermined, or of low confidence. Such points are computed
/// again from their own start with their verdict's advice (whirl_advice_apply, the factor rounded up to a power of
/// two), the cheapest first, in up to WHIRL_MAX_ROUNDS rounds. All zero: none.
typedef struct whirl_budget {
    /// Revolutions; those at n times the steps of the study count n times. No bit then depends on the speed of the
    /// computer.
    double revolutions;
    double seconds; ///< seconds instead; points that are not done in time stay as they were
} whirl_budget;

/// A study: batches of points of one family of machines.
typedef struct whirl_study {
    whirl_budget refine;                    ///< budget for points in doubt
    size_t batch_count;                     ///< number of batches
    whirl_batch batches[WHIRL_MAX_BATCHES]; ///< in the order in which they are computed
    /// Makes the machine for a value of the batch's parameter; called from several threads at once. All machines of a
    /// study have the same dimension, probes and contacts. The system gets the batch's stop, or else ends only between
    /// revolutions.
    whirl_status (*machine)(const void *family, const whirl_batch *batch, double value, whirl_machine *machine);
    const void *family; ///< borrowed
} whirl_study;

/// A share of a study for one of several runs that compute it together. Points are dealt one by one, with these
/// exceptions: each direction of a carried sweep stays together, as do eight neighbouring points at rest (except
/// run-ups), and all branches belong to the first share. A refined map is dealt by its first squares; points on an edge
/// between two squares belong to both shares, with the same bits.
typedef struct whirl_share {
    size_t number; ///< number of the share, 1 to count
    size_t count;  ///< number of shares; 0: not shared
} whirl_share;

/// Returns true if a point, given by a store's batch and slot, belongs to a share (in a refined map: may belong to it).
/// True for all points if there are no shares.
bool whirl_share_has(const whirl_study *study, const whirl_share *share, size_t batch, size_t slot);

/// Stages of a run. Each has points of its own.
typedef enum whirl_stage {
    WHIRL_STAGE_COMPUTE = 0, ///< the points of the study
    WHIRL_STAGE_CONFIRM, ///< the same points at the second tolerance; revolutions of both stages are reported together
    WHIRL_STAGE_NEIGHBOURS, ///< starts from neighbours; every round reports revolutions and seconds of its own
    WHIRL_STAGE_FOLLOW, ///< perturbed copies of chaotic motions that may be transient, with revolutions of their own
    WHIRL_STAGE_REFINE, ///< points in doubt; every round reports revolutions and seconds of its own
    WHIRL_STAGE_TABLES  ///< film tables, before the points; points and revolutions count tables
} whirl_stage;

/// Progress of a run.
typedef struct whirl_progress {
    whirl_stage stage;                ///< the present stage
    int round;                        ///< round of refinement, or of starts from neighbours, from 1; else 0
    size_t points_done, points_total; ///< points; the total grows while a map is refined, like that of revolutions
    double revolutions_done, revolutions_total; ///< revolutions; n times the study's steps count n times
    double revolutions_recalled;                ///< revolutions done that a store had from an earlier run
    double seconds;                             ///< seconds since the start
} whirl_progress;

/// The state of an unfinished point after some revolutions.
typedef struct whirl_point_state {
    size_t batch, slot; ///< a store's batch and slot of the point
    double revolutions; ///< revolutions computed
    const void *bytes;  ///< [size]
    size_t size;        ///< number of bytes
} whirl_point_state;

/// A store of finished points outside of a run, so that a later run of the same study can continue (a journal, see
/// whirl/engine/journal.h). A point is identified by its batch and its slot in the batch's table. For points that
/// are computed several times, `batch` is the batch's index plus batch_count times the pass. The pass is four times the
/// round of refinement, plus one at the second tolerance, plus two or three for copies of chaotic motions, whose
/// `block` is shorter. All functions are called by one thread at a time.
struct whirl_point_store {
    /// Stores a finished point: its block [size] and, in pass 0, the state [dimension] from which a carried point
    /// starts, all NaN if the motion diverged. An error ends the run.
    whirl_status (*keep)(void *context, size_t batch, size_t slot, const double *block, size_t size, const double *end,
                         size_t dimension);
    /// Returns true for a stored point, and fills its block and end, to the bit. Called before a point is computed.
    bool (*recall)(void *context, size_t batch, size_t slot, double *block, size_t size, double *end, size_t dimension);
    /// Syncs stored points to disk; called a few times a second. May be NULL. An error ends the run.
    whirl_status (*tend)(void *context);
    void *context; ///< passed to every function; borrowed
    /// Stores the states of all unfinished motions of thread `worker`, in place of its earlier ones, so that long
    /// points need not begin again. Called every few seconds. May be NULL. A failure is not an error.
    void (*save)(void *context, size_t worker, const whirl_point_state *states, size_t count);
    /// Returns the latest stored state of a point that begins, to be freed by free, or NULL.
    void *(*saved)(void *context, size_t batch, size_t slot, double *revolutions, size_t *size);
};

/// A dealer: deals points of a study to several runs that compute it at the same time, each with a store of its own.
/// Points are dealt in pieces. A piece is a single point, or the confirmation of one; a whole direction of a carried
/// sweep, which is confirmed by the run that computed it; eight neighbours at rest; or one run-up. Branches and tori
/// are not dealt: the gathering run follows them. No bit of a result depends on the dealing. `open` and `claim` are
/// called by one thread at a time.
typedef struct whirl_dealer {
    int threads; ///< threads of all runs together
    /// Returns true if a point, given by a store's batch and slot, is to be computed by one of the runs: false if it
    /// was stored before they began. The answer is the same in all runs, at any time.
    bool (*open)(void *context, size_t batch, size_t slot);
    /// Claims the next of the `count` pieces of a pass, given by a store's batch. Returns their number, from *first
    /// on; 0: none are left.
    size_t (*claim)(void *context, size_t batch, size_t count, size_t *first);
    /// Called in the gathering run when it has no more points to compute, or was stopped: waits for the end of the
    /// other runs, and passes the contents of their stores to its own. The run then takes all points from there, even
    /// if it was stopped, and continues with steps that need all points. An error ends the run. NULL: another run
    /// gathers, and this one ends with its points and a partial result.
    whirl_status (*gather)(void *context);
    void *context; ///< passed to every function; borrowed
} whirl_dealer;

/// Options of a run. All zero: all cores, no output.
typedef struct whirl_run_options {
    int threads; ///< 0: all cores
    /// Receives progress a few times a second from one thread at a time, and at the end. May be NULL.
    void (*progress)(void *context, const whirl_progress *progress);
    void *context;                  ///< passed to progress; borrowed
    const whirl_stop *stop;         ///< NULL, or a flag that becomes true when the run shall end early
    const whirl_point_store *store; ///< NULL: every point is computed
    /// Size of a table's blocks, bytes, above which they stay with the store, if there is one, which must then live as
    /// long as the result; 0: 256 MB. Blocks of confirmed or refined points stay in memory.
    size_t memory;
    /// Share of the points to be computed and confirmed. The run ends after that, since following and refining need all
    /// points; its result is partial. All zero: all points.
    whirl_share share;
    /// Take points and their confirmations from the store only: WHIRL_STOPPED if one is missing. Branches that were
    /// begun are followed to their end, and steps that need all points are computed.
    bool gather;
    const whirl_dealer *dealer; ///< NULL: the run computes all points, or its share
} whirl_run_options;

/// Finds the unbalances by rule (whirl_record_options.antinodes_of, placed_at) of a batch, and sets them in the batch.
/// They are those of the machine at the case's own value of the varied parameter and at the largest running speed.
/// *placed is borrowed by the batch and freed by free; NULL if the batch asks for none or has them. Runs call it
/// themselves. WHIRL_BAD_INPUT with a sentence if the machine has no such mode or station; WHIRL_NO_MEMORY.
whirl_status whirl_study_place(const whirl_study *study, whirl_batch *batch, whirl_placed **placed);

/// Makes the machine of a point of a batch, by its index in `values` (0 if nothing varies), plus s times the count for
/// start s; a start from a neighbour has the machine's first start. Errors as those of study->machine.
whirl_status whirl_study_machine(const whirl_study *study, const whirl_batch *batch, size_t point,
                                 whirl_machine *machine);

/// Replaces the method "auto" of every batch: dop853, or rodas5p if whirl_method_probe at the first, the middle and the
/// last value of the parameter counts less work for it. All points of a batch use one method. The choice is a pure
/// function of the study. Runs, outlines and verifications call it themselves. Errors as those of the machines.
whirl_status whirl_study_choose_methods(whirl_study *study);

/// Limits of starts.
enum {
    WHIRL_MAX_STARTS = 65536, ///< starts for each parameter value
    WHIRL_MAX_RANGES = 32     ///< coordinates in which starts differ
};

/// Returns a number between 0 and 1 of the Halton sequence (Numerische Mathematik 2, 1960, eq. 1): the digits of
/// `index` in base p mirrored at the point, p the prime number `coordinate` (0: 2, 1: 3, ..., below WHIRL_MAX_RANGES).
/// Several coordinates of rising indices fill their cube evenly.
double whirl_halton(size_t index, size_t coordinate);

/// Returns the options of finding orbits along the branches of a batch. Replace the method "auto" before.
whirl_orbit_options whirl_batch_orbits(const whirl_batch *batch);

/// Returns the revolutions of all points without refinement, as a budget counts them: a revolution at n times the steps
/// of the study counts n times. For a refined map those of the corners of its first squares, the only points known
/// before it runs; starts from neighbours are not included.
double whirl_study_revolutions(const whirl_study *study);

/// Builds the result of a study before any point is computed: tables without blocks, and the film tables of
/// whirl_study_prepare (whirl_result_film_tables). The rest is empty (see whirl_case_describe_result). Freed by
/// whirl_result_free.
whirl_status whirl_study_outline(const whirl_study *study, whirl_result **outline);

/// Builds the film tables for the first points of a study, on options->threads, with progress. Runs do so themselves;
/// call it before an outline, or before methods are chosen, to have progress and stops. WHIRL_STOPPED, WHIRL_NO_MEMORY.
whirl_status whirl_study_prepare(const whirl_study *study, const whirl_run_options *options);

/// Runs all batches. `result` gets one table per batch; the rest is empty (see whirl_case_describe_result). The first
/// error of a point ends the run, without a result. WHIRL_STOPPED if it was stopped before the last point was done,
/// confirmed or refined: the result then has the points that are done (whirl_table_done), and NaN for others; there is
/// none if it was stopped in whirl_study_prepare. WHIRL_NO_MEMORY if memory ran out anywhere: no number depends on its
/// amount. With a budget the blocks have the fields "refine/...": rounds, cost, and the final options. No bit of a
/// result depends on the points that a store had. The result is freed by whirl_result_free.
whirl_status whirl_study_run(const whirl_study *study, const whirl_run_options *options, whirl_result **result);

#ifdef __cplusplus
}
#endif
#endif
