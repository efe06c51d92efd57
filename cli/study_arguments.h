/// Arguments of commands that make a result, `whirl run` and `whirl merge`.
#ifndef CLI_STUDY_ARGUMENTS_H
#define CLI_STUDY_ARGUMENTS_H

#include <stdbool.h>

#include "case_arguments.h"

enum { STUDY_PATH_SIZE = 4096, COMMAND_LINE_SIZE = 256, MAX_JOURNALS = 4096 };

typedef struct study_arguments {
    case_arguments given;
    const char *output; ///< NULL: no file
    bool json, json_full, quiet, resume, force, refine, merge;
    double max_time;     ///< seconds; 0: no limit
    whirl_budget budget; ///< budget of refinement; all zero: as many revolutions as the study has
    whirl_share share;   ///< all zero: the whole study
    size_t journal_count;
    const char *journals[MAX_JOURNALS]; ///< journals elsewhere than next to the result
    char default_output[STUDY_PATH_SIZE];
    char command_line[COMMAND_LINE_SIZE];
} study_arguments;

/// Keys of the shared options. A command's own keys begin at KEY_STUDY_OWN.
enum { KEY_FORCE = KEY_OWN, KEY_JSON, KEY_REFINE, KEY_MAX_TIME, KEY_STUDY_OWN };

/// Rows of options that both commands have in their tables.
#define OUTPUT_OPTION                                                                                                  \
    {                                                                                                                  \
        .name = "output", .key = 'o', .arg = "RESULT.h5",                                                              \
        .doc = "Write the result here (default: the case's name with .h5, in the current folder)"                      \
    }
#define REFINE_OPTION                                                                                                  \
    {                                                                                                                  \
        .name = "refine", .key = KEY_REFINE, .arg = "BUDGET", .flags = OPTION_ARG_OPTIONAL,                            \
        .doc = "Compute points with an undetermined or low-confidence verdict again, as it advises (longer, or "       \
               "with a tighter tolerance), until BUDGET is spent: revolutions, as in --refine=2e6, or time, as in "    \
               "--refine='10 min' (default: as many revolutions as the study has)"                                     \
    }

/// Keeps the command line as it was typed, before argp reorders it.
void note_command_line(study_arguments *arguments, int argc, char **argv);

/// Parses -o, -q, --force, --json, --refine, --max-time and the arguments of parse_case_argument in an argp parser.
error_t parse_study_argument(study_arguments *arguments, int key, char *argument, struct argp_state *state);

/// Sets the default name of the result: the case's name with .h5, in the current folder.
void name_output(study_arguments *arguments, const struct argp_state *state);

/// Reads a share, "2/7"; reports an error for other texts.
whirl_share parse_share(const char *text, const struct argp_state *state);

#endif
