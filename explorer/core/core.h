/// The C core for the explorer's worker: a few functions with handles, numbers and JSON.
///
/// A function that can fail returns 0, or a null handle, and leaves {"message": ..., "problems": [...]} to
/// explorer_message. Returned texts are valid until the next call. One thread.
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

/// Message of the last failure.
const char *explorer_message(void);

/// Stores the message of a status. Returns true for WHIRL_OK.
bool explorer_good(const whirl_status *status);

// ---------------------------------------------------------------- cases

/// Parses a case. Freed by explorer_case_free.
whirl_case *explorer_case_new(const char *source, size_t length, const char *name);
void explorer_case_free(whirl_case *object);

/// whirl_case_assign.
int explorer_assign(whirl_case *object, const char *assignment);

/// Returns the present text of the case, which assignments to keys change.
const char *explorer_case_text(const whirl_case *object);

/// CaseInfo of protocol.ts as JSON.
const char *explorer_describe(const whirl_case *object);

/// Returns the text of the case with one value written in place, or its key removed (value NULL); see whirl_case_edit.
/// NULL after a failure.
const char *explorer_edit(const char *source, size_t length, const char *path, const char *value);

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
    whirl_batch batch;    ///< without values
    whirl_placed *placed; ///< unbalances by rule that it borrows, or NULL
    whirl_layout layout;  ///< after explorer_plan_layout
    size_t dimension;
    look look;
} plan;

/// Makes a plan from the case's batch of a name ("": the first one) over a parameter ("": nothing varies; NULL: as in
/// the batch). Freed by explorer_plan_free.
plan *explorer_plan_new(const whirl_case *object, const char *batch, const char *parameter);
void explorer_plan_free(plan *p);

/// Changes an option by its name in results ("steps_per_revolution", "transient", ...).
int explorer_plan_number(plan *p, const char *option, double value);
int explorer_plan_method(plan *p, const char *method);

/// Chooses the method if the plan's is "auto": `known`, or for "" the command's choice for the batch (as
/// explorer_plan_layout does). Returns the method.
const char *explorer_plan_choose(plan *p, const char *known);

/// Reduces the plan to a preview: at most `transient` + `record` revolutions (0: unchanged), and `steps` fixed steps
/// (0: unchanged). Call it after all other options. If anything is reduced, points have no verdict unless a longer run
/// must give the same.
void explorer_plan_look(plan *p, int transient, int record, int steps);

/// Requests the fields of a diagram.
void explorer_plan_diagram(plan *p);

/// Also requests fields of spectra, such as amplitude and phase at the running speed: 10 to 20 % more work.
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

/// Scales and stations of the machine at a value as JSON. NULL after a failure.
const char *explorer_machine(const plan *p, double value);

// ---------------------------------------------------------------- points

typedef struct job job;

/// Starts points at `values` [count], each from its own start or, if `carried`, from the end of the previous one.
/// `start` [dimension] replaces the case's start; NULL: none. The plan must outlive the job. Free it with
/// explorer_job_free.
job *explorer_job_new(const plan *p, const double *values, size_t count, int carried, const double *start);
void explorer_job_free(job *j);

/// Carries all current motions over one revolution. Returns the revolutions done: 0 at the end, -1 after a failure.
double explorer_job_turn(job *j);

/// Takes a finished point: returns its index, or -1 if there is none. Writes its block and its end, NaN if it diverged.
int explorer_job_take(job *j, double *block, double *end);

// ---------------------------------------------------------------- run-ups

/// Requests what the page shows of a run-up over the time: an orbit for every row, and spectra. Call it before
/// explorer_plan_layout.
void explorer_plan_run(plan *p);

/// Returns the length of the run in s, as planned.
double explorer_run_duration(const plan *p);

/// Writes the block [explorer_block_size] of the run at a value. While it runs, Module.passed is called after every
/// turn of the shaft with the time in s up to which the block is filled in. 0 after a failure.
int explorer_run(const plan *p, double value, double *block);

// ---------------------------------------------------------------- orbits along branches

/// Requests the fields of an orbit of so many revolutions (0: of its own period, or an equilibrium), by the plan's
/// batch, which traces branches. Call it after all other options, before explorer_plan_layout.
void explorer_plan_orbit(plan *p, int revolutions);

/// Returns the size of the nodes of such an orbit in doubles: the states at the beginnings of its segments.
size_t explorer_orbit_size(const plan *p, int revolutions, double period);

/// Writes the block of the orbit with these nodes [explorer_orbit_size] at a value, stable or not: each of its segments
/// is followed from its own node. 0 after a failure.
int explorer_orbit(const plan *p, double value, int revolutions, double period, const double *nodes, double *block);

// ---------------------------------------------------------------- motions to look at

/// Revolutions of one motion, sampled.
typedef struct motion motion;

/// explorer_motion_new: starts the machine of a plan at a value, from `state` [dimension], or from its own start for
/// NULL. Free it with explorer_motion_free.
motion *explorer_motion_new(const plan *p, double value, const double *state, int samples);
void explorer_motion_free(motion *m);

size_t explorer_motion_samples(const motion *m); ///< a revolution
size_t explorer_motion_contacts(const motion *m);

/// Carries the motion over one revolution. Writes states [samples][dimension] and forces [samples][contacts]. Returns 1
/// if it stays bounded, else 0.
int explorer_motion_turn(motion *m, double *states, double *forces);

/// Returns the present state [dimension]; borrowed.
const double *explorer_motion_state(const motion *m);

#endif
