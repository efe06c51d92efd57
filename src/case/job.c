// The stable interface for cases and their runs, through handles.
#include "whirl/job.h"
#include "whirl/engine/case.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "content.h"

// ---------------------------------------------------------------- cases

whirl_status whirl_case_check(const char *text, size_t length, const char *name, char *problems, size_t size,
                              whirl_case **out) {
    whirl_problems found = {0};
    *out = NULL;
    const whirl_status status = whirl_case_parse(text, length, name, &found, out);
    whirl_problems_text(&found, problems, size);
    whirl_problems_free(&found);
    return status;
}

const char *whirl_case_text(const whirl_case *object, size_t *length) {
    *length = object->length;
    return object->text;
}

whirl_status whirl_case_spend(whirl_case *object, double revolutions, double seconds) {
    whirl_study study;
    whirl_budget budget = {.revolutions = revolutions, .seconds = seconds};
    if (!(revolutions >= 0.0) || !(seconds >= 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the budget of %g revolutions and %g s is invalid, expected numbers of at least 0",
                          revolutions, seconds);
    const whirl_status status = whirl_case_study(object, &study);
    if (status.code != WHIRL_OK) return status;
    if (revolutions == 0.0 && seconds == 0.0) budget.revolutions = whirl_study_revolutions(&study);
    whirl_case_refine(object, budget);
    return whirl_ok();
}

// ---------------------------------------------------------------- jobs

enum { MAX_THREADS = 1024 };

struct whirl_job {
    whirl_job_run_fn *run;
    const void *subject;
    int threads;
    const whirl_point_store *store;
    whirl_job_progress_fn tell;
    void *context;
    whirl_stop stop;
};

whirl_status whirl_job_of(whirl_job_run_fn *run, const void *subject, whirl_job **job) {
    *job = calloc(1, sizeof **job);
    if (!*job) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a run");
    (*job)->run = run;
    (*job)->subject = subject;
    return whirl_ok();
}

static whirl_status run_case(const void *subject, const whirl_run_options *options, whirl_result **result) {
    return whirl_case_run(subject, options, result);
}

whirl_status whirl_job_new(const whirl_case *object, whirl_job **job) {
    return whirl_job_of(run_case, object, job);
}

void whirl_job_free(whirl_job *job) {
    free(job);
}

whirl_status whirl_job_threads(whirl_job *job, int threads) {
    if (threads < 0 || threads > MAX_THREADS)
        return whirl_fail(WHIRL_BAD_INPUT, "threads is %d, expected 0 (all cores) to %d", threads, MAX_THREADS);
    job->threads = threads;
    return whirl_ok();
}

void whirl_job_progress(whirl_job *job, whirl_job_progress_fn tell, void *context) {
    job->tell = tell;
    job->context = context;
}

void whirl_job_keep(whirl_job *job, const whirl_point_store *store) {
    job->store = store;
}

void whirl_job_stop(whirl_job *job) {
    job->stop = true;
}

static void pass_on(void *context, const whirl_progress *progress) {
    static const char *const stages[] = {
        [WHIRL_STAGE_COMPUTE] = "compute", [WHIRL_STAGE_CONFIRM] = "confirm",       [WHIRL_STAGE_FOLLOW] = "follow",
        [WHIRL_STAGE_REFINE] = "refine",   [WHIRL_STAGE_NEIGHBOURS] = "neighbours", [WHIRL_STAGE_TABLES] = "tables"};
    const whirl_job *job = context;
    const size_t stage = (size_t)progress->stage;
    job->tell(job->context, stage < sizeof stages / sizeof *stages ? stages[stage] : "compute",
              (double)progress->points_done, (double)progress->points_total, progress->revolutions_done,
              progress->revolutions_total, progress->seconds);
}

static whirl_run_options options_of(whirl_job *job) {
    return (whirl_run_options){.threads = job->threads,
                               .progress = job->tell ? pass_on : NULL,
                               .context = job,
                               .stop = &job->stop,
                               .store = job->store,
                               .memory = SIZE_MAX};
}

whirl_status whirl_job_prepare(whirl_job *job) {
    const whirl_run_options options = options_of(job);
    whirl_study study;
    if (job->run != run_case) return whirl_ok();
    const whirl_status status = whirl_case_study(job->subject, &study);
    return status.code == WHIRL_OK ? whirl_study_prepare(&study, &options) : status;
}

whirl_status whirl_job_run(whirl_job *job, whirl_result **result) {
    const whirl_run_options options = options_of(job);
    *result = NULL;
    return job->run(job->subject, &options, result);
}
