#include "journal.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "output.h"

enum { PATH_SIZE = 4096 };

static bool name_journal(const char *output, char path[PATH_SIZE]) {
    if (snprintf(path, PATH_SIZE, "%s.journal", output) < PATH_SIZE) return true;
    complain("the name of the result is too long");
    return false;
}

static bool is_there(const char *path) {
    return access(path, F_OK) == 0 || errno != ENOENT;
}

// ---------------------------------------------------------------- going on

static int read_finished(const char *output, whirl_result **finished) {
    const whirl_status status = whirl_result_read(output, finished);
    return complain_of(&status);
}

/// Without a journal: the result may be there already.
static int find_finished(const char *output, const char *path, const whirl_result *outline, whirl_result **finished) {
    char difference[WHIRL_MESSAGE_SIZE];
    size_t done, total;
    if (!is_there(output)) {
        complain("there is nothing to resume: neither '%s' nor '%s' is there", path, output);
        return EXIT_BAD_INPUT;
    }
    whirl_result *there;
    const whirl_status status = whirl_result_read_outline(output, &there);
    if (status.code != WHIRL_OK) return complain_of(&status);
    const bool same = whirl_result_same_study(there, outline, difference, sizeof difference);
    const bool partial = whirl_result_partial(there, &done, &total);
    whirl_result_free(there);
    if (partial)
        complain("there is nothing to resume: '%s' is partial (%zu of %zu points), but its journal '%s' is gone",
                 output, done, total, path);
    else if (!same)
        complain("there is nothing to resume: '%s' is not there, and '%s' is of another study: %s", path, output,
                 difference);
    else
        return read_finished(output, finished);
    return EXIT_BAD_INPUT;
}

/// Points of all tables.
static size_t count_points(const whirl_result *outline) {
    size_t count = 0;
    for (size_t i = 0; i < outline->table_count; i++) count += outline->tables[i].count;
    return count;
}

static void tell_what_was_found(const char *path, const whirl_journal *journal, size_t total, bool quiet) {
    const whirl_journal_found found = whirl_journal_look(journal);
    if (found.damaged > 0)
        complain("'%s' is damaged in %zu place%s; what is lost there is computed again", path, found.damaged,
                 found.damaged == 1 ? "" : "s");
    if (!quiet) complain("going on from '%s': %zu of %zu points are there", path, found.points, total);
}

/// Removes RESULT.h5.tmp-PROCESS, half results of runs that were killed while they wrote: who holds the journal's lock
/// is the only one to write this result.
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

static int resume_journal(const char *output, const char *path, const whirl_result *outline, bool quiet,
                          whirl_journal **journal, whirl_result **finished) {
    if (!is_there(path)) {
        const int outcome = find_finished(output, path, outline, finished);
        if (outcome == EXIT_DONE && !quiet) complain("there is nothing to resume: '%s' is complete", output);
        return outcome;
    }
    const whirl_status status = whirl_journal_resume(path, outline, journal);
    if (status.code != WHIRL_OK) return complain_of(&status);
    remove_leftovers(output);
    tell_what_was_found(path, *journal, count_points(outline), quiet);
    return EXIT_DONE;
}

static int begin_journal(const char *output, const char *path, const whirl_result *outline, bool force,
                         whirl_journal **journal) {
    if (is_there(path)) {
        complain("'%s' has the points of a run that did not finish: add --resume to go on with it, or remove it to "
                 "begin anew",
                 path);
        return EXIT_BAD_INPUT;
    }
    if (!force && !output_is_free(output)) return EXIT_FAILED;
    const whirl_status status = whirl_journal_begin(path, outline, journal);
    return complain_of(&status);
}

int open_journal(const char *output, const whirl_case *object, bool resume, bool force, bool quiet,
                 whirl_journal **journal, whirl_result **finished) {
    char path[PATH_SIZE];
    whirl_result *outline;
    *journal = NULL;
    *finished = NULL;
    if (!name_journal(output, path)) return EXIT_FAILED;
    const whirl_status status = whirl_case_outline(object, &outline);
    if (status.code != WHIRL_OK) return complain_of(&status);
    const int outcome = resume ? resume_journal(output, path, outline, quiet, journal, finished)
                               : begin_journal(output, path, outline, force, journal);
    whirl_result_free(outline);
    return outcome;
}

// ---------------------------------------------------------------- ending early

void leave_journal(const char *output, whirl_journal *journal) {
    if (!journal) return;
    const size_t points = whirl_journal_points(journal);
    const whirl_status status = whirl_journal_close(journal);
    if (status.code != WHIRL_OK) complain("%s", status.message);
    complain("%zu finished point%s kept in '%s.journal'; the same command with --resume goes on from there", points,
             points == 1 ? " is" : "s are", output);
}
