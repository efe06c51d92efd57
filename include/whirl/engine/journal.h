/// Journals: finished points on disk while a run goes on, so that a run that was killed can go on from them.
///
/// A journal is one file: a header with the case and all that the numbers depend on, then one record a point, each with
/// a checksum, written as soon as the point is finished and synced every few seconds. Whatever happens to the process,
/// the points written remain; whatever happens to the file, no wrong number is taken from it. See docs/journal.md.
///
///     whirl_case_outline(object, &outline);
///     whirl_journal_begin("paper.h5.journal", outline, &journal);     or whirl_journal_resume
///     options.keeper = whirl_journal_keeper(journal);
///     whirl_case_run(object, &options, &result);
///     whirl_result_write(result, "paper.h5");  whirl_result_verify(result, "paper.h5");
///     whirl_journal_remove(journal);                                  or whirl_journal_close
///
/// The outline of a study that no case describes has to say what tells its machines from others: the fact "equations"
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

/// Begins a journal of the study that `outline` describes (whirl_case_outline). WHIRL_BAD_INPUT when there is a file of
/// that name; WHIRL_IO_ERROR when it cannot be made, or the disk has no room for all points.
whirl_status whirl_journal_begin(const char *path, const whirl_result *outline, whirl_journal **journal);

/// Opens the journal of a run that ended early. WHIRL_BAD_INPUT with a sentence when there is none, when it is in use,
/// or when it is of another study: the sentence names the difference. A file that is damaged is mended: what is lost of
/// it is computed again. To be closed in either way below.
whirl_status whirl_journal_resume(const char *path, const whirl_result *outline, whirl_journal **journal);

/// The points that a journal is for, of one of several runs that compute a study together (whirl_share_has).
typedef struct whirl_journal_part {
    /// Whether it has a point, which a keeper knows by this batch and slot; NULL: it has all.
    bool (*has)(const void *context, size_t batch, size_t slot);
    const void *context; ///< must live as long as the journal
} whirl_journal_part;

/// The same for a part of the points: room on the disk is asked for these.
whirl_status whirl_journal_begin_part(const char *path, const whirl_result *outline, const whirl_journal_part *part,
                                      whirl_journal **journal);

/// Opens a part that is there and goes on with it, as whirl_journal_resume.
whirl_status whirl_journal_resume_part(const char *path, const whirl_result *outline, const whirl_journal_part *part,
                                       whirl_journal **journal);

/// Copies from another journal of the same study, which another run may be writing, the points that this one is for and
/// has not; what was found counts in whirl_journal_look. Errors as those of whirl_journal_resume.
whirl_status whirl_journal_take(whirl_journal *journal, const char *path);

/// Whether a run is writing the journal of that name.
bool whirl_journal_in_use(const char *path);

/// Removes a journal that another one has taken the points of. WHIRL_BAD_INPUT where a run is writing it.
whirl_status whirl_journal_discard(const char *path);

/// What a journal held when it was resumed.
typedef struct whirl_journal_found {
    size_t points;  ///< that need not be computed again
    size_t damaged; ///< places where the file is not what was written
    bool torn;      ///< the last record was cut off, as a kill leaves it
} whirl_journal_found;

/// What a journal held when it was resumed, and what was taken from others since.
whirl_journal_found whirl_journal_look(const whirl_journal *journal);

/// Whether a point is in the journal, which a keeper knows by this batch and slot.
bool whirl_journal_has(const whirl_journal *journal, size_t batch, size_t slot);

/// Points that are in the journal now.
size_t whirl_journal_points(const whirl_journal *journal);

/// The keeper for whirl_run_options; lives as long as the journal. After an error (a full disk) the journal holds what
/// was written before; the point that could not be written is tried again with the next one and when closing.
const whirl_keeper *whirl_journal_keeper(whirl_journal *journal);

/// Syncs and closes the journal; the file stays. WHIRL_IO_ERROR when points could not be written.
whirl_status whirl_journal_close(whirl_journal *journal);

/// Closes and removes the journal: when the result is safe.
whirl_status whirl_journal_remove(whirl_journal *journal);

#ifdef __cplusplus
}
#endif
#endif
