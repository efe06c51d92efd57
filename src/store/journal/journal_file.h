// A journal's file: locked against a second writer, written to its last byte or with a reason why not.
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

/// Makes the file, which must not be there, or opens one that is; and locks it. WHIRL_IO_ERROR with path and reason,
/// WHIRL_BAD_INPUT where it is there already, is not there, or belongs to a run that goes on.
whirl_status journal_file_create(journal_file *file, const char *path);
whirl_status journal_file_open(journal_file *file, const char *path);
void journal_file_close(journal_file *file);

/// Opens a file that another run may be writing, to read it. Errors as above.
whirl_status journal_file_peek(journal_file *file, const char *path);

/// Whether no run is writing an open file.
bool journal_file_is_free(const journal_file *file);

/// "cannot write PATH: reason".
whirl_status journal_file_failed(const journal_file *file, const char *what, int reason);

/// All of the following are 0 or an errno; what a signal interrupts is done again.
int journal_file_size(const journal_file *file, uint64_t *size);
int journal_file_read(const journal_file *file, uint64_t offset, void *to, size_t size);
int journal_file_write(const journal_file *file, uint64_t offset, const void *from, size_t size);
int journal_file_sync(const journal_file *file); ///< data
int journal_file_cut(const journal_file *file, uint64_t size);

/// Reserves room on the disk for a file of `size` bytes, so that a full disk is met before there is something to lose.
/// 0 also where the file system cannot.
int journal_file_reserve(const journal_file *file, uint64_t size);

/// Makes the name last through a power failure, where the file system can.
void journal_file_sync_name(const journal_file *file);

/// Removes the file.
int journal_file_remove(const journal_file *file);

#endif
