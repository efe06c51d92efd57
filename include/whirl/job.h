/// Handles for cases and for runs of their studies; results have handles in whirl/handles.h.
///
///     whirl_case_check(text, length, "paper.yaml", problems, sizeof problems, &object);
///     whirl_job_new(object, &job);
///     whirl_job_run(job, &result);
///     whirl_result_free(result);  whirl_job_free(job);  whirl_case_free(object);
///
/// Stable interface: docs/abi.md says for how long.
#ifndef WHIRL_JOB_H
#define WHIRL_JOB_H

#include <stddef.h>

#include "whirl/handles.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A parsed case. Only whirl_case_set, whirl_case_assign, whirl_case_spend and whirl_case_refine change it; afterwards
/// threads may share it.
typedef struct whirl_case whirl_case;

/// Reads and checks the text of a case as whirl_case_parse does. Writes every problem to `problems`, one line each in
/// the form of whirl_problem_text, cut at `size` bytes; "" if there is none. *out is freed by whirl_case_free.
whirl_status whirl_case_check(const char *text, size_t length, const char *name, char *problems, size_t size,
                              whirl_case **out);

/// Returns the present text of the case, byte for byte. Borrowed until the case is changed.
const char *whirl_case_text(const whirl_case *object, size_t *length);

/// Returns the title of the case, "" if it has none; borrowed.
const char *whirl_case_title(const whirl_case *object);

/// Sets a parameter ("r_k=0.45", "omega=6000 rpm", "c== 2*0.1e-3") or a key of the case: of a station ("disc.mass=41
/// kg"), of an element ("film.clearance=0.1 mm"; "film[2].clearance" if there are several), of the study
/// ("integrate.transient=5000"), or by its path ("rotor.speed=650"). A key is changed in the text of the case, which
/// the result then contains. The whole case is checked again: WHIRL_BAD_INPUT (with the nearest name) leaves it
/// unchanged. The swept parameter is refused, unless the ends of the sweep or the values of its detail depend on it.
whirl_status whirl_case_set(whirl_case *object, const char *assignment);

/// Sets the budget of a run for points whose verdict is in doubt (whirl_budget): revolutions, or seconds. Both 0: as
/// many revolutions as the study itself.
whirl_status whirl_case_spend(whirl_case *object, double revolutions, double seconds);

/// Builds the described result of the case's study, with provenance, before any point is computed
/// (whirl_study_outline). Freed by whirl_result_free.
whirl_status whirl_case_outline(const whirl_case *object, whirl_result **outline);

/// Frees a case; accepts NULL.
void whirl_case_free(whirl_case *object);

/// A run of a case's study: its options, and the request to stop.
typedef struct whirl_job whirl_job;

/// Receives the progress of a run a few times a second, from one thread at a time, and at the end. `stage` is one word:
/// "compute", "confirm", "neighbours", "follow" or "refine"; or "tables" while film tables are built before the points;
/// points_done and points_total then count tables. The other arguments are as in whirl_progress.
typedef void (*whirl_job_progress_fn)(void *context, const char *stage, double points_done, double points_total,
                                      double revolutions_done, double revolutions_total, double seconds);

/// Creates a job of a case, on all cores and without a store. The case must outlive the job and stay unchanged.
/// WHIRL_NO_MEMORY. Freed by whirl_job_free, also if it has not run.
whirl_status whirl_job_new(const whirl_case *object, whirl_job **job);
void whirl_job_free(whirl_job *job); ///< Frees a job that is not running; accepts NULL.

/// Sets the number of threads; 0: all cores. WHIRL_BAD_INPUT below 0 or above 1024.
whirl_status whirl_job_threads(whirl_job *job, int threads);

/// Sets the function that receives progress; NULL: none.
void whirl_job_progress(whirl_job *job, whirl_job_progress_fn tell, void *context);

/// Sets the store of finished points (whirl_journal_store), which must live as long as the job runs; NULL: none.
void whirl_job_keep(whirl_job *job, const whirl_point_store *store);

/// Asks the present run and all later runs of the job to end early. May be called from any thread and from a signal
/// handler.
void whirl_job_stop(whirl_job *job);

/// Builds the film tables that the study needs before its first point (some seconds), with progress, until a stop. Call
/// it before whirl_case_outline, which otherwise builds them and cannot be stopped. WHIRL_STOPPED, WHIRL_NO_MEMORY.
whirl_status whirl_job_prepare(whirl_job *job);

/// Runs the study, as whirl_case_run. A stopped run returns WHIRL_STOPPED and a partial result. *result is NULL if
/// there is no result; else it is freed by whirl_result_free.
whirl_status whirl_job_run(whirl_job *job, whirl_result **result);

#ifdef __cplusplus
}
#endif
#endif
