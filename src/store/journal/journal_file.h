// A journal's file: locked against a second writer, written to its last byte or with a reason why not.
#ifndef STORE_JOURNAL_FILE_H
#define STORE_JOURNAL_FILE_H

#include "journal_frame.h"
#include "store.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { JOURNAL_PATH_SIZE = 4096 };

typedef struct journal_file {
    int descriptor; ///< -1 when not open
    char path[JOURNAL_PATH_SIZE];
} journal_file;

/// Create a file, which must not exist, or open one; and lock it. WHIRL_IO_ERROR with path and reason; WHIRL_BAD_INPUT
/// if it exists (create), does not exist (open), or belongs to a run that is going on.
whirl_status journal_file_create(journal_file *file, const char *path);
whirl_status journal_file_open(journal_file *file, const char *path);
void journal_file_close(journal_file *file);

/// Opens a file that another run may be writing, to read it. Errors as above.
whirl_status journal_file_peek(journal_file *file, const char *path);

/// Returns true if no run is writing an open file.
bool journal_file_is_free(const journal_file *file);

/// "cannot write PATH: reason".
whirl_status journal_file_failed(const journal_file *file, const char *what, int reason);

/// All of the following return 0 or an errno; interrupted calls are repeated.
int journal_file_size(const journal_file *file, uint64_t *size);
int journal_file_read(const journal_file *file, uint64_t offset, void *to, size_t size);
int journal_file_write(const journal_file *file, uint64_t offset, const void *from, size_t size);
int journal_file_sync(const journal_file *file); ///< data
int journal_file_cut(const journal_file *file, uint64_t size);

/// Reserves disk space for a file of `size` bytes, so that a full disk is found before there is anything to lose.
/// Returns 0 also if the file system cannot.
int journal_file_reserve(const journal_file *file, uint64_t size);

/// Makes the name survive a power failure, if the file system can.
void journal_file_sync_name(const journal_file *file);

/// Removes the file.
int journal_file_remove(const journal_file *file);

// ---------------------------------------------------------------- crc32c
// The checksum CRC-32C (Castagnoli 1993; RFC 3720, section 12.1).

/// Checksum of bytes that follow others with the checksum `before`; 0 if there are none.
uint32_t crc32c(uint32_t before, const void *bytes, size_t size);

// ---------------------------------------------------------------- finished
// The finished points of a table, which are all that a file holds of it: a run of a million points that is stopped
// early leaves a small file.

typedef struct finished {
    whirl_table table; ///< these points, without blocks; if all are finished, with the arrays of the whole table
    size_t *points;    ///< [table.count] which points of the whole table they are; NULL: all
    whirl_mapped *mapped;
} finished;

/// The whole table must live as long.
whirl_status finished_points(const whirl_table *whole, finished *points);

/// Index in the whole table of a finished point.
static inline size_t finished_point(const finished *own, size_t at) {
    return own->points ? own->points[at] : at;
}

void finished_free(finished *points);

// ---------------------------------------------------------------- identity
// Identity of a study as text: case, parameters, points and how they are computed; no results.

/// Lines "label\tvalue
/// ", in UTF-8; to be freed. `build` adds what else the bits depend on: sources and compilation of whirl, kind of
/// arithmetic, mathematical functions of the system. WHIRL_BAD_INPUT for an unknown WHIRL_ISA.
whirl_status identity_text(const whirl_result *outline, bool build, char **text, size_t *size);

/// Writes the first difference in at most `size` bytes: "line 5 of the case was 'a' and is 'b'". False when there is
/// none.
bool identity_difference(const char *earlier, const char *later, char *difference, size_t size);

// ---------------------------------------------------------------- journal_header
// The beginning of a journal's file: of which study it is.

/// Study of a journal (journal_file.h).
typedef struct journal_identity {
    char *text;
    size_t size;
} journal_identity;

/// State of a file's header.
typedef enum header_state {
    HEADER_OURS,
    HEADER_CUT,    ///< a run was killed while it made the journal: there is nothing but the beginning of our header
    HEADER_DAMAGED ///< or no header at all
} header_state;

/// Writes the header and syncs. WHIRL_IO_ERROR, WHIRL_NO_MEMORY.
whirl_status journal_header_write(const journal_file *file, const journal_identity *identity);

/// Reads the header of a file of `file_size` bytes. WHIRL_BAD_INPUT, with the difference, if it is of another study.
whirl_status journal_header_look(const journal_file *file, const journal_identity *identity, uint64_t file_size,
                                 header_state *state);

/// Returns where the header of a journal of any study ends; 0 if the file is none, or its header is damaged.
uint64_t journal_header_end(const journal_file *file, uint64_t file_size);

/// "PATH is no journal of this study, or its beginning is damaged".
whirl_status journal_header_missing(const journal_file *file);

// ---------------------------------------------------------------- journal_scan
// Finding the frames of a journal, whatever has become of its bytes.

/// Called for every sound frame, in the order of the file; `offset` is that of its payload.
typedef void (*journal_found)(void *context, const frame_head *head, uint64_t offset);

typedef struct journal_scan {
    uint64_t end;   ///< end of the last valid frame, or the beginning of the scan
    size_t frames;  ///< sound ones
    size_t damaged; ///< gaps between valid frames with other bytes, or frames with a wrong checksum
    bool torn;      ///< the last frame is incomplete, as after a kill
} journal_scan;

/// Looks for frames from `from` on. After a bad one it goes on at the next good one. 0, or the errno of a read.
int journal_search(const byte_source *bytes, uint64_t from, journal_found found, void *context, journal_scan *scan);

#endif
