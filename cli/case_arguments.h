/// Arguments of commands that compute: a case, settings of its parameters, a number of threads.
#ifndef CLI_CASE_ARGUMENTS_H
#define CLI_CASE_ARGUMENTS_H

#include <stdbool.h>

#include "command.h"

enum { MAX_OVERRIDES = 64 };

typedef struct case_arguments {
    const char *path;
    const char *overrides[MAX_OVERRIDES];
    size_t override_count;
    int threads;
} case_arguments;

/// Keys of the options --set and --threads. A command's own keys begin at KEY_OWN.
enum { KEY_SET = 256, KEY_THREADS, KEY_OWN };

/// Row of --set in a command's table of options.
#define SET_OPTION                                                                                                     \
    {                                                                                                                  \
        .name = "set", .key = KEY_SET, .arg = "NAME=VALUE",                                                            \
        .doc = "Set a parameter of the case, as in --set r_k=0.45 or --set 'omega=6000 rpm', or another key, as in "   \
               "--set disc.mass=41; may be repeated"                                                                   \
    }

/// Row of --json in a command's table of options; each command has its own key for it.
#define JSON_OPTION(json_key, text)                                                                                    \
    {                                                                                                                  \
        .name = "json", .key = (json_key), .arg = "full", .flags = OPTION_ARG_OPTIONAL,                                \
        .doc = text "; with --json=full sections, curves and nodes as well"                                            \
    }

/// Returns true for `--json=full`; reports an error for any other value.
bool parse_json(const char *argument, const struct argp_state *state);

/// Parses the case, --set and --threads in a command's argp parser; reports an error if the case is missing.
error_t parse_case_argument(case_arguments *arguments, int key, char *argument, struct argp_state *state);

/// Returns a whole number from 1 to `most`; reports an error for any other value of `option`.
int take_whole(const char *option, const char *text, int most, const struct argp_state *state);

/// Sets the values of --set in a case. Returns the exit status, after reporting the first value that is invalid.
int apply_settings(const case_arguments *arguments, whirl_case *object);

/// Reads the case and sets the values of --set. Returns the exit status, after reporting errors.
int load_case(const case_arguments *arguments, whirl_case **object);

#endif
