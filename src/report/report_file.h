/// Writes files of a report, to a temporary name that is renamed at the end, so that no file is ever incomplete.
#ifndef REPORT_REPORT_FILE_H
#define REPORT_REPORT_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/status.h"

enum { FILE_PATH_SIZE = 4096 };

typedef struct report_file {
    FILE *stream;
    char path[FILE_PATH_SIZE];
    char temporary[FILE_PATH_SIZE + 8];
} report_file;

/// Opens `folder`/`name` for writing. Fails with WHIRL_IO_ERROR.
whirl_status report_file_open(report_file *file, const char *folder, const char *name);

/// Closes the file, checks for errors (a full disk) and renames it to its final name. A failed file is removed.
whirl_status report_file_close(report_file *file);

/// Closes and removes an incomplete file; an existing file of the final name stays.
void report_file_drop(report_file *file);

/// Creates a folder and its parents; an existing one is fine.
whirl_status folder_make(const char *path);

/// Returns true if anything of this name exists, even a dangling link.
bool report_file_there(const char *path);

/// Returns true if a folder exists and is not empty.
bool folder_holds_files(const char *path);

/// Creates a folder for a report's own files, unless it exists; refuses a link in its place.
whirl_status folder_make_own(const char *path);

/// Creates a new folder in the folder `in` and writes its path [FILE_PATH_SIZE]. Fails with WHIRL_IO_ERROR.
whirl_status folder_make_temporary(const char *in, char *path);

/// Removes a temporary folder and the files in it with the names (a list that ends with NULL).
void folder_remove(const char *path, const char *const *names);

/// Turns a text into a file name: letters, digits, '.', '_', '+' and '-' stay, other bytes become '-'. The name is
/// never empty and never begins with '.' or '-'.
void safe_name(const char *text, char *name, size_t size);

#endif
