/// What commands that compute take: a case, settings of its parameters, a number of threads.
#ifndef CLI_CASE_ARGUMENTS_H
#define CLI_CASE_ARGUMENTS_H

#include "command.h"

enum { MAX_OVERRIDES = 64 };

typedef struct case_arguments {
    const char *path;
    const char *overrides[MAX_OVERRIDES];
    size_t override_count;
    int threads;
} case_arguments;

/// Take an argument, or complain of it and end the program.
void take_case(case_arguments *arguments, char *text, const struct argp_state *state);
void take_override(case_arguments *arguments, char *text, const struct argp_state *state);
void take_threads(case_arguments *arguments, const char *text, const struct argp_state *state);

/// A whole number from 1 to `most`; complains of anything else that stands after `option`.
int take_whole(const char *option, const char *text, int most, const struct argp_state *state);

/// Reads the case with its settings; gives the exit status.
int load_case(const case_arguments *arguments, whirl_case **object);

#endif
