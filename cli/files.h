/// Files given to a command: what they are, where that is not what was asked for.
#ifndef CLI_FILES_H
#define CLI_FILES_H

#include <stdbool.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"

/// True when the file is a result, by its first bytes, or a rotor that ROSS has saved; complains then, and says what
/// can be done with it.
bool is_other_than_case(const char *path);

/// What a case from standard input is called in messages and results.
extern const char standard_input[];

/// Whether the name of a case stands for standard input: "-".
bool is_standard_input(const char *path);

/// Reads a case, from standard input where the name says so. Errors as whirl_case_load.
whirl_status read_case(const char *path, whirl_problems *problems, whirl_case **object);

/// Reads a result; gives the exit status, after complaining of what cannot be read. A case is named for what it is.
int load_result(const char *path, whirl_result **result);

/// What a command does with a result and its arguments; gives the exit status.
typedef int result_action(const whirl_result *result, const void *arguments);

/// Does it with the result of a file, and ends the output. Gives the exit status.
int with_result(const char *path, result_action *act, const void *arguments);

/// The same without the numbers of points.
int load_outline(const char *path, whirl_result **outline);

/// Whether a file may be made where `path` is: one that is there is kept unless `force`, and `input`, which is `what`
/// ("the result itself"), always. Complains if not.
bool may_write_file(const char *path, const char *input, const char *what, bool force);

/// Writes a text as a file, whole or not at all; one that is there is kept unless `force`. Gives the exit status, after
/// a complaint.
int write_whole(const char *path, bool force, const char *text);

#endif
