/// The whirl command. Each subcommand has a file of its own, and a line in the table of main.c.
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include <argp.h>

#include "whirl/engine.h"

/// Exit statuses of the whole command.
enum {
    EXIT_DONE = 0,
    EXIT_FAILED = 1,
    EXIT_BAD_INPUT = 2,
    EXIT_UNFINISHED = 3 ///< a run stopped before its last point and saved its state; --resume continues
};

typedef struct command {
    const char *name;
    const char *meaning;               ///< one line for `whirl --help`
    int (*run)(int argc, char **argv); ///< argv[0] is "whirl NAME"; returns the exit status
} command;

extern const command run_command, merge_command, verify_command, check_command, describe_command, report_command,
    export_command, show_command, new_command, import_command, figure_command, table_command, balance_command,
    bearing_command;

/// Prints "whirl: ..." and a newline on standard error.
void complain(const char *format, ...) __attribute__((format(printf, 1, 2)));

/// Prints a message like complain, with another name in front of it: "whirl run: ...".
void complain_as(const char *program, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Reports a status unless it is success; returns the matching exit status.
int complain_of(const whirl_status *status);

/// Reads the arguments of a command as argp_parse does, but suggests the nearest option for a misspelt one. Returns
/// EXIT_DONE or the exit status of the failure.
int read_arguments(const struct argp *argp, int argc, char **argv, unsigned flags, void *input);

/// Reports an error in the arguments and ends the program with EXIT_BAD_INPUT.
void bad_argument(const struct argp_state *state, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Ends the program with an error if a required option is missing (`value` is NULL).
void require_option(const struct argp_state *state, const char *value, const char *option);

/// Reports all problems of a file, one a line, and their number; without problems reports `status`. Frees them and
/// returns the exit status: EXIT_BAD_INPUT, or EXIT_FAILED without memory.
int complain_of_problems(whirl_problems *problems, const whirl_status *status);

/// Writes the name of a file without its folders and without `suffix`, at most `size` bytes.
void base_name(const char *path, const char *suffix, char *name, size_t size);

/// Flushes standard output. Returns EXIT_DONE, or EXIT_FAILED after reporting that something could not be written.
int finish_output(void);

#endif
