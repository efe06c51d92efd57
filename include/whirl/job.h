/// Cases and runs of their studies through handles, as whirl/handles.h has results.
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

// ---------------------------------------------------------------- cases

/// A parsed case: immutable but for whirl_case_set, whirl_case_spend and whirl_case_refine, safe to share between
/// threads afterwards.
typedef struct whirl_case whirl_case;

/// Reads and checks the text of a case as whirl_case_parse does. Where anything is wrong, all of it is written to
/// `problems` as whirl_problem_text has it, a line each, cut at `size` bytes; else "". *out is freed by
/// whirl_case_free.
whirl_status whirl_case_check(const char *text, size_t length, const char *name, char *problems, size_t size,
                              whirl_case **out);

/// The text of the case as it is now, byte for byte. Borrowed until the case is changed.
const char *whirl_case_text(const whirl_case *object, size_t *length);

/// The title that the case gives itself, "" where it has none; borrowed.
const char *whirl_case_title(const whirl_case *object);

/// Sets a parameter ("r_k=0.45", "omega=6000 rpm", "c== 2*0.1e-3") or a key of the case: of a station ("disc.mass=41
/// kg"), an element ("film.clearance=0.1 mm"; "film[2].clearance" where there are several), the study
/// ("integrate.transient=5000"), or by its path ("rotor.speed=650"). A key is changed in the text of the case, which a
/// result then holds. The whole case is checked again: WHIRL_BAD_INPUT (nearest name named) leaves it as it was. The
/// parameter that a sweep varies is refused, unless the ends of the sweep or the values of its detail depend on it.
whirl_status whirl_case_set(whirl_case *object, const char *assignment);

/// Sets what a run of the case may spend on points whose verdict is in doubt (whirl_budget): revolutions, or seconds;
/// both 0: as many revolutions as the study itself.
whirl_status whirl_case_spend(whirl_case *object, double revolutions, double seconds);

/// The result of the case's study before any point is computed (whirl_study_outline), described, provenance included.
/// Freed by whirl_result_free.
whirl_status whirl_case_outline(const whirl_case *object, whirl_result **outline);

/// Frees a case; NULL is none.
void whirl_case_free(whirl_case *object);

// ---------------------------------------------------------------- jobs

/// A run of a case's study: how it is to be done, and whether it shall stop.
typedef struct whirl_job whirl_job;

/// Is told how far a run has come, a few times a second from one thread at a time, and at the end. `stage` says what is
/// being done, in a word: "compute", "confirm", "neighbours", "follow", "refine", or "tables": tables of films, in
/// the place of points, are made before. The rest is as in whirl_progress.
typedef void (*whirl_job_progress_fn)(void *context, const char *stage, double points_done, double points_total,
                                      double revolutions_done, double revolutions_total, double seconds);

/// A job of a case, which must outlive it and not change meanwhile: on all cores, without a keeper. WHIRL_NO_MEMORY.
/// Freed by whirl_job_free, also before it has run.
whirl_status whirl_job_new(const whirl_case *object, whirl_job **job);
void whirl_job_free(whirl_job *job); ///< Frees a job that is not running; NULL is none.

/// How many threads: 0 for all cores. WHIRL_BAD_INPUT where it is below 0 or above 1024.
whirl_status whirl_job_threads(whirl_job *job, int threads);

/// Who is told of progress; NULL: nobody.
void whirl_job_progress(whirl_job *job, whirl_job_progress_fn tell, void *context);

/// Where finished points are kept (whirl_journal_keeper); NULL: nowhere. Must live as long as the job runs.
void whirl_job_keep(whirl_job *job, const whirl_keeper *keeper);

/// Asks a run to end early, and those after it. May be called from any thread and from a signal handler.
void whirl_job_stop(whirl_job *job);

/// Makes what the study of a case needs before its first point (tables of films, some seconds), with progress, until a
/// stop: for who asks for whirl_case_outline before the run, which makes it otherwise without an end. WHIRL_STOPPED,
/// WHIRL_NO_MEMORY.
whirl_status whirl_job_prepare(whirl_job *job);

/// Runs the study, as whirl_case_run. Stopped, it gives WHIRL_STOPPED and a partial result too. *result is NULL where
/// there is none; else it is freed by whirl_result_free.
whirl_status whirl_job_run(whirl_job *job, whirl_result **result);

#ifdef __cplusplus
}
#endif
#endif
