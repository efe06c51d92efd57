/// A file that appears whole or not at all: written under a temporary name in the same folder, synced, then renamed.
#ifndef STORE_ATOMIC_FILE_H
#define STORE_ATOMIC_FILE_H

#include "whirl/status.h"

#include <stdbool.h>
#include <stdio.h>

enum { ATOMIC_PATH_SIZE = 4096 };

typedef struct atomic_file {
    FILE *stream; ///< stream (or descriptor) to write to; NULL when not open
    char path[ATOMIC_PATH_SIZE], temporary[ATOMIC_PATH_SIZE];
} atomic_file;

/// Opens the temporary file. WHIRL_IO_ERROR with path and reason: a folder of that name, no such parent folder, ...
whirl_status atomic_file_open(atomic_file *out, const char *path);

/// Closes the file; renames it to `path` if everything was written, else removes it and reports the failure.
whirl_status atomic_file_commit(atomic_file *out);

/// Removes the temporary file.
void atomic_file_discard(atomic_file *out);

/// Returns true if anything of this name exists, even a dangling link.
bool atomic_file_there(const char *path);

/// Creates a folder and its missing parents; an existing one is fine.
whirl_status atomic_folder(const char *path);

#endif
