#include "case_arguments.h"

#include "guard.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"

enum { MAX_THREADS = 1024 };

static void take_case(case_arguments *arguments, char *text, const struct argp_state *state) {
    if (arguments->path) bad_argument(state, "takes one case, '%s' is one too many", text);
    arguments->path = text;
}

static void take_override(case_arguments *arguments, char *text, const struct argp_state *state) {
    if (arguments->override_count == MAX_OVERRIDES)
        bad_argument(state, "--set is given more than %d times", MAX_OVERRIDES);
    arguments->overrides[arguments->override_count++] = text;
}

bool parse_json(const char *argument, const struct argp_state *state) {
    if (argument && strcmp(argument, "full") != 0)
        bad_argument(state, "--json is '%s', expected full, or nothing after it", argument);
    return argument != NULL;
}

int take_whole(const char *option, const char *text, int most, const struct argp_state *state) {
    char *end = NULL;
    errno = 0;
    const long value = strtol(text, &end, 10);
    if (end == text || *end != '\0' || errno != 0 || value < 1 || value > most)
        bad_argument(state, "%s is '%s', expected a whole number from 1 to %d", option, text, most);
    return (int)value;
}

error_t parse_case_argument(case_arguments *arguments, int key, char *argument, struct argp_state *state) {
    switch (key) {
    case KEY_THREADS:
        arguments->threads = take_whole("--threads", argument, MAX_THREADS, state);
        return 0;
    case KEY_SET:
        take_override(arguments, argument, state);
        return 0;
    case ARGP_KEY_ARG:
        take_case(arguments, argument, state);
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->path, "CASE.yaml");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

int apply_settings(const case_arguments *arguments, whirl_case *object) {
    for (size_t i = 0; i < arguments->override_count; i++) {
        const whirl_status status = whirl_case_set(object, arguments->overrides[i]);
        if (status.code == WHIRL_OK) continue;
        complain("--set %s: %s", arguments->overrides[i], status.message);
        if (status.code == WHIRL_NO_MEMORY) guard_note_exhausted();
        return status.code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
    }
    return EXIT_DONE;
}

int load_case(const case_arguments *arguments, whirl_case **object) {
    whirl_problems problems = {0};
    if (is_other_than_case(arguments->path)) return EXIT_BAD_INPUT;
    const whirl_status status = read_case(arguments->path, &problems, object);
    if (status.code != WHIRL_OK) return complain_of_problems(&problems, &status);
    return apply_settings(arguments, *object);
}
