/// Journals: finished points on disk during a run, so that a later run can continue after a kill.
///
/// A journal is one file: a header with the case and all other inputs of the numbers, then one record per point with a
/// checksum, written as soon as the point is finished and synced every few seconds. Written points survive any end of
/// the process; damage to the file never yields a wrong number. See docs/journal.md.
///
///     whirl_case_outline(object, &outline);
///     whirl_journal_begin("paper.h5.journal", outline, &journal);     or whirl_journal_resume
///     options.store = whirl_journal_store(journal);
///     whirl_case_run(object, &options, &result);
///     whirl_result_write(result, "paper.h5");  whirl_result_verify(result, "paper.h5");
///     whirl_journal_remove(journal);                                  or whirl_journal_close
///
/// The outline of a study without a case must have the fact "equations", which distinguishes its machines from others
/// (whirl_result_add_fact).
#ifndef WHIRL_JOURNAL_H
#define WHIRL_JOURNAL_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/result.h"
#include "whirl/engine/study.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// An open journal. No other run can open it meanwhile.
typedef struct whirl_journal whirl_journal;

/// Begins a journal of the study of `outline` (whirl_case_outline). WHIRL_BAD_INPUT if a file of that name exists;
/// WHIRL_IO_ERROR if it cannot be created, or the disk lacks space for all points.
whirl_status whirl_journal_begin(const char *path, const whirl_result *outline, whirl_journal **journal);

/// Opens the journal of a run that ended early. WHIRL_BAD_INPUT with a sentence if there is none, it is in use, or it
/// belongs to another study: the sentence names the difference. A damaged file is repaired: lost points are computed
/// again. Closed by whirl_journal_close or whirl_journal_remove.
whirl_status whirl_journal_resume(const char *path, const whirl_result *outline, whirl_journal **journal);

/// The points of a journal of one of several runs that compute a study together (whirl_share_has).
typedef struct whirl_journal_part {
    /// Returns true for a point of the journal, given by a store's batch and slot; NULL: all points.
    bool (*has)(const void *context, size_t batch, size_t slot);
    const void *context; ///< passed to `has`; must live as long as the journal
} whirl_journal_part;

/// Begins a journal for a part of the points, for which it checks the space on the disk.
whirl_status whirl_journal_begin_part(const char *path, const whirl_result *outline, const whirl_journal_part *part,
                                      whirl_journal **journal);

/// Opens the journal of such a part, as whirl_journal_resume.
whirl_status whirl_journal_resume_part(const char *path, const whirl_result *outline, const whirl_journal_part *part,
                                       whirl_journal **journal);

/// Copies points from another journal of the same study, which another run may be writing: those that this journal is
/// for and does not have yet. whirl_journal_look counts them. Errors as those of whirl_journal_resume.
whirl_status whirl_journal_take(whirl_journal *journal, const char *path);

/// Returns true if a run is writing the journal of that name.
bool whirl_journal_in_use(const char *path);

/// Returns true if the file of that name is an empty journal: no run is writing it, and it holds neither finished
/// points nor states of unfinished ones. Runs that failed or were killed early leave such a file.
bool whirl_journal_vacant(const char *path);

/// Removes a journal whose points another one has taken. WHIRL_BAD_INPUT if a run is writing it.
whirl_status whirl_journal_discard(const char *path);

/// Contents of a journal when it was opened.
typedef struct whirl_journal_found {
    size_t points;  ///< points that need not be computed again
    size_t damaged; ///< places at which the file differs from the data written
    bool torn;      ///< the last record is incomplete, as after a kill
} whirl_journal_found;

/// Returns the contents of a journal when it was opened, plus the points taken from others since.
whirl_journal_found whirl_journal_look(const whirl_journal *journal);

/// Returns true if a point, given by a store's batch and slot, is in the journal.
bool whirl_journal_has(const whirl_journal *journal, size_t batch, size_t slot);

/// Returns the number of points in the journal.
size_t whirl_journal_points(const whirl_journal *journal);

/// Returns the store of points for whirl_run_options; it lives as long as the journal. After an error (a full disk) the
/// journal contains everything written before; the failed point is written again with the next one and on closing.
const whirl_point_store *whirl_journal_store(whirl_journal *journal);

/// Syncs and closes the journal; the file stays. WHIRL_IO_ERROR if points could not be written.
whirl_status whirl_journal_close(whirl_journal *journal);

/// Closes and deletes the journal. Call it when the result is safe.
whirl_status whirl_journal_remove(whirl_journal *journal);

#ifdef __cplusplus
}
#endif
#endif
