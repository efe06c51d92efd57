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

/// Keys of the options --set and --threads; a command's own begin at KEY_OWN.
enum { KEY_SET = 256, KEY_THREADS, KEY_OWN };

/// The part of an argp parser that takes these arguments, the case among them, without which it complains in the end.
error_t parse_case_argument(case_arguments *arguments, int key, char *argument, struct argp_state *state);

/// A whole number from 1 to `most`; complains of anything else that stands after `option`.
int take_whole(const char *option, const char *text, int most, const struct argp_state *state);

/// Reads the case with its settings; gives the exit status.
int load_case(const case_arguments *arguments, whirl_case **object);

#endif
