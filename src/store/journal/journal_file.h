// The file of a journal: locked against a second writer; writes are complete, or their failure has a reason.
#ifndef STORE_JOURNAL_FILE_H
#define STORE_JOURNAL_FILE_H

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

/// Opens a file for reading without a lock: another run may be writing it. Errors as above.
whirl_status journal_file_peek(journal_file *file, const char *path);

/// Returns true if no run is writing an open file.
bool journal_file_is_free(const journal_file *file);

/// Returns the failure "cannot WHAT PATH: REASON"; reason: an errno.
whirl_status journal_file_failed(const journal_file *file, const char *what, int reason);

/// All functions below return 0 or an errno; interrupted calls are repeated.
int journal_file_size(const journal_file *file, uint64_t *size);
int journal_file_read(const journal_file *file, uint64_t offset, void *to, size_t size);
int journal_file_write(const journal_file *file, uint64_t offset, const void *from, size_t size);
int journal_file_sync(const journal_file *file); ///< syncs the data
int journal_file_cut(const journal_file *file, uint64_t size);

/// Reserves disk space for a file of `size` bytes, so that a full disk is found before points are computed. Returns 0
/// also if the file system cannot reserve space.
int journal_file_reserve(const journal_file *file, uint64_t size);

/// Makes the name survive a power failure, if the file system can.
void journal_file_sync_name(const journal_file *file);

/// Removes the file.
int journal_file_remove(const journal_file *file);

#endif
