/// The whirl command: one file a subcommand, each a line in the table of main.c.
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include <argp.h>

#include "whirl/engine.h"

/// Exit statuses of the whole command.
enum {
    EXIT_DONE = 0,
    EXIT_FAILED = 1,
    EXIT_BAD_INPUT = 2,
    EXIT_UNFINISHED = 3 ///< a run ended in good order before its last point; --resume goes on
};

typedef struct command {
    const char *name;
    const char *meaning;               ///< one line for `whirl --help`
    int (*run)(int argc, char **argv); ///< argv[0] is "whirl NAME"; gives the exit status
} command;

extern const command run_command, merge_command, verify_command, check_command, describe_command, report_command,
    export_command, show_command, new_command, import_command, figure_command, table_command, balance_command,
    bearing_command;

/// Prints "whirl: ..." and a newline on standard error.
void complain(const char *format, ...) __attribute__((format(printf, 1, 2)));

/// The same with another name in front: "whirl run".
void complain_as(const char *program, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Complains of a status; gives the exit status that goes with it.
int complain_of(const whirl_status *status);

/// Reads the arguments of a command as argp_parse does, after complaining of a misspelt option with the one that was
/// meant; gives EXIT_DONE or the exit status.
int read_arguments(const struct argp *argp, int argc, char **argv, unsigned flags, void *input);

/// Ends a parse with a sentence and EXIT_BAD_INPUT.
void bad_argument(const struct argp_state *state, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Complains of an option that must be there and is not, when `value` is NULL.
void require_option(const struct argp_state *state, const char *value, const char *option);

/// Reports all problems of a file, one a line, and their number; without problems reports `status`. Frees them and
/// returns the exit status: EXIT_BAD_INPUT, or EXIT_FAILED without memory.
int complain_of_problems(whirl_problems *problems, const whirl_status *status);

/// The file's name without folders and without `suffix`; writes at most `size` bytes.
void base_name(const char *path, const char *suffix, char *name, size_t size);

/// Flushes standard output; complains and gives EXIT_FAILED when something could not be written.
int finish_output(void);

#endif
