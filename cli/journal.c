#include "journal.h"

#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "output.h"
#include "records.h"

enum { PATH_SIZE = JOURNAL_NAME_SIZE };

static bool is_there(const char *path) {
    return access(path, F_OK) == 0 || errno != ENOENT;
}

// ---------------------------------------------------------------- an existing result

static int read_finished(const char *output, whirl_result **finished) {
    const whirl_status status = whirl_result_read(output, finished);
    return complain_of(&status);
}

/// Called if there is no journal: reads the complete result of the study, or reports why there is none. Returns the
/// exit status.
static int find_finished(const journal_wish *wish, const char *path, const whirl_result *outline,
                         whirl_result **finished) {
    const char *output = wish->output, *what = wish->merge ? "merge" : "resume";
    char difference[WHIRL_MESSAGE_SIZE];
    size_t done, total;
    if (!is_there(output)) {
        complain("there is nothing to %s: neither '%s' nor '%s' is there", what, path, output);
        return EXIT_BAD_INPUT;
    }
    // Compare the existing result with the study.
    whirl_result *there;
    const whirl_status status = whirl_result_read_outline(output, &there);
    if (status.code != WHIRL_OK) return complain_of(&status);
    const bool same = whirl_result_same_study(there, outline, difference, sizeof difference);
    const bool partial = whirl_result_partial(there, &done, &total);
    whirl_result_free(there);
    // A partial result cannot be resumed without its journal; a complete one of the same study is the outcome.
    if (partial)
        complain("there is nothing to %s: '%s' is partial (%zu of %zu points), but its journal '%s' is gone", what,
                 output, done, total, path);
    else if (!same)
        complain("there is nothing to %s: '%s' is not there, and '%s' is of another study: %s", what, path, output,
                 difference);
    else
        return read_finished(output, finished);
    return EXIT_BAD_INPUT;
}

// ---------------------------------------------------------------- points of a rank

/// Returns true for points that a rank's journal has room for or takes from other journals. A new journal reserves
/// space for an equal share of the points, whichever they will be. Later it takes carried points, which the rank may
/// have to continue. The journal of the first rank is for all points.
static bool is_for_rank(const run_journal *journal, size_t batch, size_t slot) {
    const whirl_share *rank = &journal->wish->owner.share, share = {rank->number + 1, rank->count};
    if (!journal->journal) return whirl_share_has(&journal->study, &share, batch, slot);
    return journal->study.batches[batch % journal->study.batch_count].carry != WHIRL_CARRY_NONE;
}

static bool is_of_share(const void *context, size_t batch, size_t slot) {
    const run_journal *journal = context;
    return journal->wish->owner.is_rank ? is_for_rank(journal, batch, slot)
                                        : whirl_share_has(&journal->study, &journal->wish->owner.share, batch, slot);
}

/// Writes the number of points of the journal, as in "7 of 12 points". For refined maps and starts from neighbours the
/// total is not known before the end, and is left out.
static void points_text(const run_journal *journal, const whirl_result *outline, char *text, size_t size) {
    const size_t found = whirl_journal_look(journal->journal).points;
    size_t count = 0;
    bool known = true;
    for (size_t i = 0; i < outline->table_count; i++) {
        known = known && outline->tables[i].refine == 0 && outline->tables[i].neighbours == 0;
        for (size_t slot = 0; slot < outline->tables[i].count; slot++) count += is_of_share(journal, i, slot);
    }
    if (known)
        snprintf(text, size, "%zu of %zu points", found, count);
    else
        snprintf(text, size, "%zu points", found);
}

static void report_found(const run_journal *journal, const whirl_result *outline, size_t others) {
    const whirl_journal_found found = whirl_journal_look(journal->journal);
    char others_text[64] = "", points[64];
    points_text(journal, outline, points, sizeof points);
    if (others > 0)
        snprintf(others_text, sizeof others_text, " and %zu other journal%s", others, others == 1 ? "" : "s");
    if (found.damaged > 0)
        complain("'%s'%s %s damaged in %zu place%s; what is lost there is computed again", journal->path, others_text,
                 others > 0 ? "are" : "is", found.damaged, found.damaged == 1 ? "" : "s");
    if (!journal->wish->quiet) complain("going on from '%s'%s: %s are there", journal->path, others_text, points);
}

/// Removes RESULT.h5.tmp-PROCESS, incomplete results of killed runs. This is safe: only the process that has locked the
/// journal writes the result.
static void remove_leftovers(const char *output) {
    char folder[PATH_SIZE], pattern[PATH_SIZE], path[2 * PATH_SIZE];
    const char *slash = strrchr(output, '/');
    const int length = slash ? (int)(slash - output) + 1 : 0;
    snprintf(folder, sizeof folder, "%.*s", length ? length : 2, length ? output : "./");
    snprintf(pattern, sizeof pattern, "%s.tmp-", output + length);
    DIR *list = opendir(folder);
    for (const struct dirent *entry; list && (entry = readdir(list)) != NULL;) {
        const char *number = entry->d_name + strlen(pattern);
        if (strncmp(entry->d_name, pattern, strlen(pattern)) != 0 || !*number || number[strspn(number, "0123456789")])
            continue;
        snprintf(path, sizeof path, "%s%s", folder, entry->d_name);
        unlink(path);
    }
    if (list) closedir(list);
}

// ---------------------------------------------------------------- existing journals

/// Returns true for a journal of this run or shard, whose points a run without --resume would ignore; false for
/// journals of other shards.
static bool is_in_the_way(const journal_wish *wish, const journal_name *name) {
    const whirl_share *own = &wish->owner.share, *other = &name->owner.share;
    return name->owner.is_rank || other->count != own->count || other->number == own->number;
}

/// Returns true if no journal blocks the run; otherwise reports a journal that has points or that another run is
/// writing.
static bool is_free(const journal_wish *wish, const journal_names *there) {
    const bool alone = wish->resume && !wish->merge && wish->owner.share.count == 0;
    for (size_t i = 0; i < there->count; i++) {
        const char *path = there->items[i].path;
        if (!wish->resume && is_in_the_way(wish, &there->items[i])) {
            // A journal without points is removed.
            if (whirl_journal_vacant(path) && whirl_journal_discard(path).code == WHIRL_OK) continue;
            complain("'%s' has the points of a run that did not finish: add --resume to go on with it, or remove it to "
                     "begin anew",
                     path);
            return false;
        }
        if (alone && there->items[i].owner.share.count > 0 && whirl_journal_in_use(path)) {
            complain("another run is writing %s", path);
            return false;
        }
    }
    return true;
}

/// Returns true if an existing result may be replaced: a partial one, or one of the same study when a run is resumed.
static bool gives_way(const journal_wish *wish, const whirl_result *outline) {
    char difference[WHIRL_MESSAGE_SIZE];
    size_t done, total;
    whirl_result *there = NULL;
    bool known = false;
    if (wish->resume && whirl_result_read_outline(wish->output, &there).code == WHIRL_OK)
        known = whirl_result_partial(there, &done, &total) ||
                whirl_result_same_study(there, outline, difference, sizeof difference);
    whirl_result_free(there);
    return known;
}

// ---------------------------------------------------------------- opening

static int open_own(run_journal *journal, const whirl_result *outline) {
    const journal_wish *wish = journal->wish;
    const whirl_journal_part part = {is_of_share, journal};
    if (is_there(journal->path)) {
        const whirl_status status = whirl_journal_resume_part(journal->path, outline, &part, &journal->journal);
        if (status.code == WHIRL_OK && wish->owner.share.count == 0) remove_leftovers(wish->output);
        return complain_of(&status);
    }
    const bool may_begin = wish->force || wish->owner.is_rank || gives_way(wish, outline);
    if (!may_begin && !output_is_free(wish->output)) return EXIT_FAILED;
    // A shard writes no files of records.
    if (!may_begin && wish->owner.share.count == 0 && !record_files_are_free(outline, wish->output)) return EXIT_FAILED;
    const whirl_status status = whirl_journal_begin_part(journal->path, outline, &part, &journal->journal);
    return complain_of(&status);
}

static int take(const run_journal *journal, const char *path) {
    if (journal->wish->merge && whirl_journal_in_use(path))
        complain("'%s' is being written: what it has so far counts", path);
    const whirl_status status = whirl_journal_take(journal->journal, path);
    return complain_of(&status);
}

/// Takes the points of all other journals of the study, next to the result and elsewhere. Writes their number to
/// *count.
static int take_others(run_journal *journal, journal_names *there, size_t *count) {
    const journal_wish *wish = journal->wish;
    int outcome = EXIT_DONE;
    *count = wish->other_count;
    for (size_t i = 0; i < there->count && outcome == EXIT_DONE; i++) {
        if (strcmp(there->items[i].path, journal->path) == 0) continue;
        outcome = take(journal, there->items[i].path);
        (*count)++;
    }
    for (size_t i = 0; i < wish->other_count && outcome == EXIT_DONE; i++) outcome = take(journal, wish->others[i]);
    journal->taken = *there;
    *there = (journal_names){0};
    return outcome;
}

static int open_with(run_journal *journal, const whirl_result *outline, journal_names *there, whirl_result **finished) {
    const journal_wish *wish = journal->wish;
    const bool empty = there->count + wish->other_count == 0;
    size_t others = 0;
    if (!is_free(wish, there)) return EXIT_BAD_INPUT;
    // A shard with --resume begins if it has no journal, so that all jobs of an array have the same command.
    if (wish->resume && empty && (wish->owner.share.count == 0 || is_there(wish->output))) {
        const int outcome = find_finished(wish, journal->path, outline, finished);
        if (outcome == EXIT_DONE && !wish->quiet)
            complain("there is nothing to %s: '%s' is complete", wish->merge ? "merge" : "resume", wish->output);
        return outcome;
    }
    int outcome = open_own(journal, outline);
    if (outcome != EXIT_DONE || !wish->resume || empty) return outcome;
    outcome = take_others(journal, there, &others);
    if (outcome == EXIT_DONE) report_found(journal, outline, others);
    return outcome;
}

int open_journal(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished) {
    whirl_result *outline;
    *journal = (run_journal){.wish = wish};
    *finished = NULL;
    if (!name_journal(wish->output, wish->owner, journal->path)) return EXIT_FAILED;
    whirl_status status = whirl_case_study(object, &journal->study);
    if (status.code == WHIRL_OK) status = whirl_case_outline(object, &outline);
    if (status.code != WHIRL_OK) return complain_of(&status);
    journal_names there = find_journals(wish->output);
    const int outcome = open_with(journal, outline, &there, finished);
    if (outcome != EXIT_DONE && journal->journal) {
        const whirl_status closed = whirl_journal_close(journal->journal);
        if (closed.code != WHIRL_OK) complain("%s", closed.message);
        journal->journal = NULL;
    }
    if (outcome != EXIT_DONE) free_journal_names(&journal->taken);
    free_journal_names(&there);
    whirl_result_free(outline);
    return outcome;
}

// ---------------------------------------------------------------- ranks

/// Opens the journal of a rank. Taking points from the first rank's journal also checks that both have the same study
/// and folder.
int open_rank_journal(const journal_wish *wish, const whirl_case *object, const journal_names *there,
                      run_journal *journal) {
    whirl_result *outline = NULL;
    *journal = (run_journal){.wish = wish};
    if (!name_journal(wish->output, wish->owner, journal->path)) return EXIT_FAILED;
    whirl_status status = whirl_case_study(object, &journal->study);
    if (status.code == WHIRL_OK) status = whirl_case_outline(object, &outline);
    if (status.code != WHIRL_OK) return complain_of(&status);
    const int opened = open_own(journal, outline);
    for (size_t i = 0; i < there->count && opened == EXIT_DONE && status.code == WHIRL_OK; i++)
        if (strcmp(there->items[i].path, journal->path) != 0)
            status = whirl_journal_take(journal->journal, there->items[i].path);
    whirl_result_free(outline);
    return opened == EXIT_DONE ? complain_of(&status) : opened;
}

whirl_status take_rank_journals(run_journal *journal, int ranks) {
    char path[JOURNAL_NAME_SIZE];
    whirl_status status = whirl_ok();
    for (int i = 1; i < ranks && status.code == WHIRL_OK; i++) {
        const journal_owner owner = {.share = {(size_t)i, (size_t)ranks}, .is_rank = true};
        if (!name_journal(journal->wish->output, owner, path)) return whirl_fail(WHIRL_IO_ERROR, "a name is too long");
        status = whirl_journal_take(journal->journal, path);
        add_journal_name(&journal->taken, path, owner);
    }
    return status;
}

// ---------------------------------------------------------------- ending

/// Closes the journal, reports a failure, and returns the number of its points.
static size_t close_journal(run_journal *journal, whirl_status *status) {
    const size_t points = whirl_journal_points(journal->journal);
    *status = whirl_journal_close(journal->journal);
    if (status->code != WHIRL_OK) complain("%s", status->message);
    journal->journal = NULL;
    free_journal_names(&journal->taken);
    return points;
}

void abandon_journal(run_journal *journal) {
    if (!journal->journal) return;
    const whirl_status status =
        journal->wish->resume ? whirl_journal_close(journal->journal) : whirl_journal_remove(journal->journal);
    if (status.code != WHIRL_OK) complain("%s", status.message);
    journal->journal = NULL;
    free_journal_names(&journal->taken);
}

int close_rank_journal(run_journal *journal) {
    whirl_status status = whirl_ok();
    if (journal->journal) close_journal(journal, &status);
    return status.code == WHIRL_OK ? EXIT_DONE : EXIT_FAILED;
}

void leave_journal(run_journal *journal) {
    whirl_status status;
    if (!journal->journal) return;
    const size_t points = close_journal(journal, &status);
    complain("%zu finished point%s kept in '%s'; %s", points, points == 1 ? " is" : "s are", journal->path,
             journal->wish->merge ? "'whirl run' with --resume computes the others, in shards or not"
                                  : "the same command with --resume goes on from there");
}

int close_shard(run_journal *journal) {
    const whirl_share share = journal->wish->owner.share;
    whirl_status status;
    const size_t points = close_journal(journal, &status);
    if (status.code == WHIRL_OK && !journal->wish->quiet)
        complain("shard %zu of %zu is done: %zu point%s kept in '%s'; 'whirl merge' makes the result of all shards",
                 share.number, share.count, points, points == 1 ? " is" : "s are", journal->path);
    return status.code == WHIRL_OK ? EXIT_DONE : EXIT_FAILED;
}

void remove_journal(run_journal *journal) {
    if (!journal->journal) return;
    const whirl_status status = whirl_journal_remove(journal->journal);
    if (status.code != WHIRL_OK) complain("%s", status.message); // the result is safe all the same
    journal->journal = NULL;
    for (size_t i = 0; i < journal->taken.count; i++) {
        const char *path = journal->taken.items[i].path;
        const whirl_status gone = strcmp(path, journal->path) == 0 ? whirl_ok() : whirl_journal_discard(path);
        if (gone.code != WHIRL_OK) complain("%s", gone.message);
    }
    free_journal_names(&journal->taken);
}
