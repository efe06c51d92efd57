/// Interface of the C core for the explorer's worker: functions with handles, numbers and JSON.
///
/// A function that can fail returns 0, or a null handle, and leaves {"message": ..., "problems": [...]} to
/// explorer_message. Returned texts are valid until the next call. All calls must come from one thread.
#ifndef EXPLORER_CORE_H
#define EXPLORER_CORE_H

#include "text.h"
#include "whirl/engine/case.h"
#include "whirl/engine/study.h"

#if defined(__EMSCRIPTEN__)
#include <emscripten.h>
#define EXPORTED EMSCRIPTEN_KEEPALIVE
#else
#define EXPORTED
#endif

/// Returns the message of the last failure.
const char *explorer_message(void);

/// Stores the message of a status. Returns true for WHIRL_OK.
bool explorer_good(const whirl_status *status);

// ---------------------------------------------------------------- cases

/// Parses a case; free it with explorer_case_free.
whirl_case *explorer_case_new(const char *source, size_t length, const char *name);
void explorer_case_free(whirl_case *object);

/// Assigns a value to a parameter or key as whirl_case_assign does.
int explorer_assign(whirl_case *object, const char *assignment);

/// Returns the present text of the case, which assignments to keys change.
const char *explorer_case_text(const whirl_case *object);

/// Returns the CaseInfo of protocol.ts as JSON.
const char *explorer_describe(const whirl_case *object);

/// Returns the text of the case with one value written in place, or its key removed (value NULL); see whirl_case_edit.
/// NULL after a failure.
const char *explorer_edit(const char *source, size_t length, const char *path, const char *value);

// ---------------------------------------------------------------- measured numbers

/// Reads the bytes of a file of measured numbers for the machine of a case, as `study: fit` reads files; `name` is the
/// file's in messages. columns: a line for each column that is read, its heading, a tab, and its name in the file; ""
/// for all. Returns the MeasuredTable of protocol.ts as JSON. NULL after a failure.
const char *explorer_measured(const whirl_case *object, const char *name, const void *bytes, size_t size,
                              const char *columns);

/// Returns the columns of the bytes of a file as MeasuredColumn of protocol.ts, a list in JSON. NULL after a failure.
const char *explorer_measured_columns(const char *name, const void *bytes, size_t size);

/// Returns the largest number of rows of explorer_measured_spectrum.
size_t explorer_measured_orders(void);

/// Computes the spectrum of a measured motion: `turn` [count] are revolutions since a mark, growing; `values`
/// [2][count] x and y at these. Writes rows [explorer_measured_orders][5] as whirl_signals_spectrum: with the window of
/// spectra of computed motions; for fewer than 4 revolutions the Fourier coefficients of whole revolutions, without a
/// window. Returns the number of rows; 0 after a failure.
int explorer_measured_spectrum(const double *turn, const double *values, size_t count, double *rows);

// ---------------------------------------------------------------- plans

/// Reductions of a preview; see explorer_plan_look.
typedef struct look {
    bool shorter, coarser;
    int transient, record, steps; ///< requested numbers
} look;

/// A plan of computation: a batch of the case with changed options.
typedef struct plan {
    const whirl_case *object; ///< borrowed
    whirl_study study;
    whirl_batch batch;    ///< copy of the case's batch, without values
    whirl_placed *placed; ///< unbalances by rule, which the batch borrows, or NULL
    whirl_layout layout;  ///< set by explorer_plan_layout
    size_t dimension;
    look look;
} plan;

/// Makes a plan from the case's batch with a name ("": the first batch) over a parameter ("": nothing varies; NULL: as
/// in the batch). Free it with explorer_plan_free.
plan *explorer_plan_new(const whirl_case *object, const char *batch, const char *parameter);
void explorer_plan_free(plan *p);

/// Changes an option by its name in results ("steps_per_revolution", "transient", ...).
int explorer_plan_number(plan *p, const char *option, double value);
int explorer_plan_method(plan *p, const char *method);

/// If the method of the plan is "auto", replaces it by `known` or, if that is "", by the command's choice for the batch
/// (as explorer_plan_layout does). Returns the method.
const char *explorer_plan_choose(plan *p, const char *known);

/// Reduces the plan to a preview: at most `transient` + `record` revolutions (0: unchanged), and `steps` fixed steps
/// (0: unchanged). Call it after all other options. If anything is reduced, points have no verdict unless a longer run
/// must give the same.
void explorer_plan_look(plan *p, int transient, int record, int steps);

/// Requests the fields of a diagram.
void explorer_plan_diagram(plan *p);

/// Also requests fields of spectra, such as amplitude and phase at the running speed, which take 10 to 20 % more time.
void explorer_plan_spectra(plan *p);

/// Requests the data that the page shows of a point, in addition to the case's analyses: whole spectra, and the
/// waveform of `waveform` revolutions.
void explorer_plan_everything(plan *p, int waveform);

/// Returns the layout of the blocks and the options as JSON; needed before points are computed. NULL after a failure.
/// `value` is one of the parameter's values.
const char *explorer_plan_layout(plan *p, double value);

/// Return the sizes of a block and of a state in doubles.
size_t explorer_block_size(const plan *p);
size_t explorer_dimension(const plan *p);

/// Returns the verdict of a block as JSON, "provisional" if a preview was too short for one.
const char *explorer_verdict(const plan *p, const double *block);

/// Returns scales and stations of the machine at a value as JSON. NULL after a failure.
const char *explorer_machine(const plan *p, double value);

// ---------------------------------------------------------------- points

typedef struct job job;

/// Starts points at `values` [count], each from its own start or, if `carried`, from the end of the previous one.
/// `start` [dimension] replaces the case's start; NULL: none. The plan must outlive the job. Free it with
/// explorer_job_free.
job *explorer_job_new(const plan *p, const double *values, size_t count, int carried, const double *start);
void explorer_job_free(job *j);

/// Advances all current motions by one revolution. Returns the number of revolutions computed: 0 at the end, -1 after a
/// failure.
double explorer_job_turn(job *j);

/// Takes a finished point: returns its index, or -1 if there is none. Writes its block and its end, NaN if it diverged.
int explorer_job_take(job *j, double *block, double *end);

// ---------------------------------------------------------------- run-ups

/// Requests the data that the page shows of a run-up over the time: an orbit for every row, and spectra. Call it before
/// explorer_plan_layout.
void explorer_plan_run(plan *p);

/// Returns the planned length of the run, s.
double explorer_run_duration(const plan *p);

/// Writes the block [explorer_block_size] of the run at a value. During the run it calls Module.passed after every turn
/// of the shaft with the time in s up to which the block is filled in. Returns 0 after a failure.
int explorer_run(const plan *p, double value, double *block);

// ---------------------------------------------------------------- orbits along branches

/// Requests the fields of an orbit that closes after `revolutions` revolutions (0: an orbit with a period of its own,
/// or an equilibrium), for a plan whose batch follows branches. Call it after all other options, before
/// explorer_plan_layout.
void explorer_plan_orbit(plan *p, int revolutions);

/// Returns the size of the nodes of such an orbit in doubles: the states at the beginnings of its segments.
size_t explorer_orbit_size(const plan *p, int revolutions, double period);

/// Writes the block of the orbit with the nodes [explorer_orbit_size] at a value. It follows each segment from its own
/// node, so that the orbit may be unstable. Returns 0 after a failure.
int explorer_orbit(const plan *p, double value, int revolutions, double period, const double *nodes, double *block);

// ---------------------------------------------------------------- motions to look at

/// A motion that is sampled revolution by revolution.
typedef struct motion motion;

/// Starts the machine of a plan at a value, from `state` [dimension] or, if that is NULL, from its own start. Free it
/// with explorer_motion_free.
motion *explorer_motion_new(const plan *p, double value, const double *state, int samples);
void explorer_motion_free(motion *m);

size_t explorer_motion_samples(const motion *m); ///< samples of a revolution
size_t explorer_motion_contacts(const motion *m);

/// Advances the motion by one revolution. Writes states [samples][dimension] and forces [samples][contacts]. Returns 1
/// if it stays bounded, else 0.
int explorer_motion_turn(motion *m, double *states, double *forces);

/// Returns the present state [dimension]; borrowed.
const double *explorer_motion_state(const motion *m);

#endif
