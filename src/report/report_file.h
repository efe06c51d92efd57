/// Files of a report: written to a temporary name and renamed, so that none is ever half there.
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

/// Opens `folder`/`name` for writing. WHIRL_IO_ERROR with a sentence.
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

/// Creates a folder that only the report writes to; a link in its place is refused.
whirl_status folder_make_own(const char *path);

/// Creates a new folder in another one; path [FILE_PATH_SIZE]. WHIRL_IO_ERROR with a sentence.
whirl_status folder_make_temporary(const char *in, char *path);

/// Removes such a folder and the files in it that have these names, ended by NULL.
void folder_remove(const char *path, const char *const *names);

/// Turns a text into a file name: letters, digits, '.', '_', '+' and '-' stay, other bytes become '-'. The name is
/// never empty and never begins with '.' or '-'.
void safe_name(const char *text, char *name, size_t size);

#endif
