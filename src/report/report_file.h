// Files of a report: written to a temporary name and renamed, so that none is ever half there.
#ifndef REPORT_FILE_H
#define REPORT_FILE_H

#include <limits.h>
#include <stdio.h>

#include "whirl/status.h"

enum { FILE_PATH_SIZE = 4096 };

typedef struct report_file {
    FILE *stream;
    char path[FILE_PATH_SIZE];
    char temporary[FILE_PATH_SIZE + 8];
} report_file;

/// Opens `folder`/`name` for writing. WHIRL_IO_ERROR with a sentence.
whirl_status report_file_open(report_file *file, const char *folder, const char *name);

/// Closes the file, looks for errors (a full disk) and gives it its name. A file that failed is removed.
whirl_status report_file_close(report_file *file);

/// Closes and removes a file that cannot be completed; one that had its name stays.
void report_file_drop(report_file *file);

/// Makes a folder and those above it; one that is there already is fine.
whirl_status folder_make(const char *path);

/// The same for a folder that only the report writes to: a link in its place is refused, for it may lead anywhere.
whirl_status folder_make_own(const char *path);

/// Makes a folder of its own in another one; path [FILE_PATH_SIZE]. WHIRL_IO_ERROR with a sentence.
whirl_status folder_make_temporary(const char *in, char *path);

/// Removes such a folder and the files in it that have these names, ended by NULL.
void folder_remove(const char *path, const char *const *names);

/// The text as a file name: letters, digits, '.', '_', '+' and '-' stay, all else becomes '-'; never empty,
/// never beginning with '.' or '-'.
void safe_name(const char *text, char *name, size_t size);

#endif
