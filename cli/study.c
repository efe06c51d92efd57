/// From a case to its result: code shared by `whirl run` and `whirl merge`.
#include "study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "files.h"
#include "guard.h"
#include "interrupt.h"
#include "journal.h"
#include "output.h"
#include "progress.h"
#include "ranks.h"
#include "records.h"
#include "together.h"
#include "whirl/engine/report.h"

enum { PATH_SIZE = 4096 };

// ---------------------------------------------------------------- computing

/// Loads the case, with the budget of --refine.
static int load(const study_arguments *arguments, whirl_case **object) {
    const int outcome = load_case(&arguments->given, object);
    if (outcome != EXIT_DONE || !arguments->refine) return outcome;
    const whirl_status status = whirl_case_spend(*object, arguments->budget.revolutions, arguments->budget.seconds);
    return status.code == WHIRL_OK ? EXIT_DONE : complain_of(&status);
}

/// Reports why a run ended early.
static void report_stop(const whirl_status *status) {
    if (*interrupt_watch())
        complain("%s (%s)", status->message, interrupt_text());
    else
        complain("%s", status->message);
}

/// Returns the exit status of a run, after reporting why it ended early. A rank that ended because another one failed
/// reports nothing.
static int outcome_of(const whirl_status *status, const together *all) {
    if (all->failed) return EXIT_UNFINISHED;
    if (status->code != WHIRL_STOPPED) return complain_of(status);
    report_stop(status);
    return EXIT_UNFINISHED;
}

/// Computes the study. A partial result may exist for any exit status.
static int compute(const study_arguments *arguments, const whirl_case *object, run_journal *journal,
                   whirl_result **result) {
    enum { LITTLE = 1 };
    const bool alone = ranks_count() == 1, whole = alone && !arguments->merge && arguments->share.count == 0;
    progress_view view = progress_begin();
    together all = {.failed = false};
    whirl_run_options how = {
        .threads = arguments->given.threads,
        .progress = arguments->quiet ? NULL : progress_show,
        .context = &view,
        .stop = interrupt_watch(),
        .store = journal->journal ? whirl_journal_store(journal->journal) : NULL,
        // Points that are in a journal need not be in memory, too.
        .memory = whole ? 0 : LITTLE,
        .share = arguments->share,
        .gather = arguments->merge,
    };
    int outcome = alone ? EXIT_DONE : together_begin(&all, object, journal, how.threads, how.progress ? &view : NULL);
    if (outcome == EXIT_DONE) {
        if (!alone) together_join(&all, &how);
        const whirl_status status = whirl_case_run(object, &how, result);
        progress_end(&view);
        outcome = outcome_of(&status, &all);
    }
    together_free(&all);
    return outcome;
}

/// Makes the film tables that the study needs, before the journal begins.
static int prepare(const study_arguments *arguments, const whirl_case *object) {
    progress_view view = progress_begin();
    const whirl_run_options how = {.threads = arguments->given.threads,
                                   .progress = arguments->quiet ? NULL : progress_show,
                                   .context = &view,
                                   .stop = interrupt_watch()};
    whirl_study study;
    whirl_status status = whirl_case_study(object, &study);
    if (status.code == WHIRL_OK) status = whirl_study_prepare(&study, &how);
    progress_end(&view);
    return outcome_of(&status, &(together){.failed = false});
}

// ---------------------------------------------------------------- how it was computed

static void now_text(char *text, size_t size) {
    const time_t now = time(NULL);
    struct tm parts;
    if (!gmtime_r(&now, &parts) || strftime(text, size, "%Y-%m-%dT%H:%M:%SZ", &parts) == 0) text[0] = '\0';
}

static whirl_status add_facts(whirl_result *result, const char *const facts[][2], size_t count) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++)
        status = whirl_result_add_fact(result, facts[i][0], facts[i][1]);
    return status;
}

// ---------------------------------------------------------------- output

/// Writes the result, then compares the file with it. Returns the exit status.
static int save(const study_arguments *arguments, const whirl_result *result) {
    guard_output(arguments->output);
    whirl_status status = whirl_result_write(result, arguments->output);
    if (status.code == WHIRL_OK) status = whirl_result_verify(result, arguments->output);
    if (status.code == WHIRL_OK) return EXIT_DONE;
    complain_of(&status);
    return EXIT_FAILED;
}

static int show(const study_arguments *arguments, const whirl_result *result) {
    if (arguments->json) {
        const whirl_status status = arguments->json_full ? whirl_result_write_json(result, stdout)
                                                         : whirl_result_write_json_summary(result, stdout);
        if (status.code != WHIRL_OK) return complain_of(&status);
    } else if (!arguments->quiet) {
        const whirl_status status = whirl_result_write_summary(result, stdout);
        if (status.code != WHIRL_OK) return complain_of(&status);
        printf("%s\n", arguments->output);
    }
    return finish_output();
}

/// Returns true if a partial result would replace the complete one of an earlier run.
static bool would_cover(const char *path, const whirl_result *result) {
    size_t done, total;
    whirl_result *earlier = NULL;
    if (!path || !whirl_result_partial(result, &done, &total)) return false;
    const bool complete =
        whirl_result_read_outline(path, &earlier).code == WHIRL_OK && !whirl_result_partial(earlier, &done, &total);
    whirl_result_free(earlier);
    return complete;
}

/// Saves and shows a result. A partial result does not replace a complete one. The journal, which has the large tables,
/// stays open until everything is printed, and is removed only when a complete result is written. Returns the exit
/// status.
static int deliver(const study_arguments *arguments, const whirl_result *result, run_journal *journal) {
    size_t done, total;
    if (would_cover(arguments->output, result)) {
        complain("'%s' holds the complete result of an earlier run and is kept", arguments->output);
        leave_journal(journal);
        return EXIT_DONE;
    }
    // Save the result.
    int saved = arguments->output ? save(arguments, result) : EXIT_DONE;
    const bool partial = whirl_result_partial(result, &done, &total);
    // Records of a data set are shown from the file: reading it leaves their signals out.
    whirl_result *from_file = NULL;
    if (saved == EXIT_DONE && arguments->output && whirl_result_records(result)) {
        saved = load_result(arguments->output, &from_file);
        if (from_file) saved = write_record_files(from_file, arguments->output);
    }
    const int shown = saved == EXIT_DONE ? show(arguments, from_file ? from_file : result) : saved;
    whirl_result_free(from_file);
    // Report a partial result, and end the journal.
    if (saved == EXIT_DONE && partial && arguments->output)
        complain("'%s' %s, and is marked so", arguments->output, done > 0 ? "is partial" : "has no points yet");
    if (saved == EXIT_DONE && !partial)
        remove_journal(journal);
    else
        leave_journal(journal);
    return shown;
}

static int deliver_with_facts(const study_arguments *arguments, whirl_result *result, const char *started,
                              run_journal *journal) {
    char finished[32], threads[16], ranks[16];
    now_text(finished, sizeof finished);
    snprintf(threads, sizeof threads, "%d", arguments->given.threads);
    snprintf(ranks, sizeof ranks, "%d", ranks_count());
    const char *const facts[][2] = {{"command line", arguments->command_line},
                                    {"started", started},
                                    {"finished", finished},
                                    {"threads", threads},
                                    {"ranks", ranks}};
    const size_t count = sizeof facts / sizeof *facts - (ranks_count() == 1);
    const whirl_status status = add_facts(result, facts, count);
    if (status.code == WHIRL_OK) return deliver(arguments, result, journal);
    leave_journal(journal);
    return complain_of(&status);
}

/// Computes the part of a rank other than the first, whose only output is its journal.
static int contribute(const study_arguments *arguments, const whirl_case *object, run_journal *journal) {
    whirl_result *part = NULL;
    int outcome = compute(arguments, object, journal, &part);
    whirl_result_free(part);
    const int closed = close_rank_journal(journal);
    if (closed != EXIT_DONE) outcome = closed;
    together_leave(outcome);
    return outcome;
}

/// Computes points or takes them from journals, then saves and shows the result. The only output of a shard is its
/// journal.
static int compute_and_deliver(const study_arguments *arguments, const whirl_case *object, run_journal *journal) {
    char started[32];
    whirl_result *result = NULL;
    now_text(started, sizeof started);
    const int outcome = compute(arguments, object, journal, &result);
    if (outcome != EXIT_DONE && outcome != EXIT_UNFINISHED) together_leave(outcome);
    int delivered = EXIT_DONE;
    if (!result || (arguments->share.count > 0 && outcome != EXIT_DONE))
        leave_journal(journal);
    else if (arguments->share.count > 0)
        delivered = close_shard(journal);
    else
        delivered = deliver_with_facts(arguments, result, started, journal);
    whirl_result_free(result);
    return delivered != EXIT_DONE ? delivered : outcome;
}

// ---------------------------------------------------------------- the whole command

/// Explains why a run was refused if several copies of `whirl` were started in parallel: they do not know of each other
/// and want the same result. Several tasks alone are no error, since each may compute something else.
static void report_tasks(const study_arguments *arguments) {
    static const char *const names[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}; // of Open MPI, of MPICH and Slurm
    for (size_t i = 0; i < sizeof names / sizeof *names && arguments->share.count == 0; i++) {
        const char *tasks = getenv(names[i]);
        if (!tasks || strtol(tasks, NULL, 10) < 2) continue;
        complain(
            "this is one of %s tasks that know nothing of each other: 'whirl-mpi run' computes one study with all of "
            "them, and so does --shard",
            tasks);
        return;
    }
}

static int open_and_compute(const study_arguments *arguments, const whirl_case *object) {
    const bool first = ranks_number() == 0;
    const whirl_share rank = {(size_t)ranks_number(), (size_t)ranks_count()};
    const journal_wish wish = {.output = arguments->output,
                               .owner = {first ? arguments->share : rank, !first},
                               .resume = arguments->resume || arguments->merge,
                               .merge = arguments->merge,
                               .force = arguments->force,
                               .quiet = arguments->quiet,
                               .other_count = arguments->journal_count,
                               .others = arguments->journals};
    run_journal journal = {.journal = NULL};
    whirl_result *finished = NULL;
    bool all_done = false;
    // Open the journal, on the first rank for all.
    int outcome = ranks_agree(prepare(arguments, object));
    if (outcome == EXIT_DONE && arguments->output)
        outcome = open_together(&wish, object, &journal, &finished, &all_done);
    if (outcome != EXIT_DONE && ranks_count() == 1) report_tasks(arguments);
    // Show what is finished, or compute the rest.
    if (outcome == EXIT_DONE && finished)
        outcome = show(arguments, finished);
    else if (outcome == EXIT_DONE && !all_done)
        outcome = first ? compute_and_deliver(arguments, object, &journal) : contribute(arguments, object, &journal);
    whirl_result_free(finished);
    return outcome;
}

static int carry_out(const study_arguments *arguments) {
    whirl_case *object = NULL;
    interrupt_watch(); // from the start: reading a case takes time too, and a full disk sends signals at the first
                       // write
    if (arguments->max_time > 0) interrupt_after(arguments->max_time);
    int outcome = load(arguments, &object);
    if (outcome == EXIT_DONE && arguments->output && !output_is_writable(arguments->output, arguments->given.path))
        outcome = EXIT_FAILED;
    outcome = ranks_agree(outcome);
    if (outcome == EXIT_DONE) {
        keep_private(arguments->given.path);
        outcome = open_and_compute(arguments, object);
    }
    whirl_case_free(object);
    return outcome;
}

int study_command(const struct argp *argp, int argc, char **argv, study_arguments *arguments) {
    note_command_line(arguments, argc, argv);
    const int read = read_arguments(argp, argc, argv, 0, arguments);
    return read == EXIT_DONE ? carry_out(arguments) : read;
}
