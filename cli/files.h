/// Reads files that are given to a command, with messages for files of another kind, and writes texts.
#ifndef CLI_FILES_H
#define CLI_FILES_H

#include <stdbool.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

/// Most columns that can be chosen from a measured file.
enum { MAX_CHOSEN_COLUMNS = 128 };

/// Returns true if a file that should be a case is a result or a rotor of ROSS, by its first bytes, after reporting
/// which command takes it.
bool is_other_than_case(const char *path);

/// Name of a case from standard input in messages and results.
extern const char standard_input[];

/// Returns true if a path means standard input: "-".
bool is_standard_input(const char *path);

/// Reads a case from a file, or from standard input if the path is "-". Errors of whirl_case_load.
whirl_status read_case(const char *path, whirl_problems *problems, whirl_case **object);

/// Reads a result, or a record (NAME.csv). Returns the exit status, after reporting an error for other files.
int load_result(const char *path, whirl_result **result);

/// Columns that are chosen from a measured file: headings, each with its name in the file.
typedef struct chosen_columns {
    size_t count;
    const char *headings[MAX_CHOSEN_COLUMNS], *names[MAX_CHOSEN_COLUMNS]; ///< [count]
} chosen_columns;

/// Reads a result, or a record of which columns are chosen; without columns as load_result. *chosen becomes true if
/// columns were chosen from it.
int load_result_columns(const char *path, const chosen_columns *columns, whirl_result **result, bool *chosen);

/// A command's function of a result and its arguments; returns the exit status.
typedef int result_action(const whirl_result *result, const void *arguments);

/// Reads a result, calls `act` with it, and flushes standard output. Returns the exit status.
int with_result(const char *path, result_action *act, const void *arguments);

/// Reads a result without the numbers of its points. Returns the exit status, after reporting errors.
int load_outline(const char *path, whirl_result **outline);

/// Returns true if `path` may be written; otherwise reports an error. An existing file needs `force`. `input`,
/// described by `what` ("the result itself"), may never be overwritten.
bool may_write_file(const char *path, const char *input, const char *what, bool force);

/// Writes a text as a file, whole or not at all; an existing one needs `force`. Returns the exit status, after
/// reporting errors.
int write_whole(const char *path, bool force, const char *text);

#endif
