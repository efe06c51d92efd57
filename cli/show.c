/// whirl show: prints the summary of existing results.
#include "command.h"

#include <stdbool.h>
#include <stdio.h>

#include "case_arguments.h"
#include "files.h"
#include "whirl/engine/report.h"

typedef struct show_arguments {
    int first; ///< index of the first result in argv
    bool json, full;
} show_arguments;

enum { KEY_JSON = KEY_OWN };

static const struct argp_option options[] = {
    JSON_OPTION(KEY_JSON, "Print the points of one result as a JSON document, as `run` does"),
    {0},
};

static error_t show_parse(int key, char *argument, struct argp_state *state) {
    show_arguments *arguments = state->input;
    switch (key) {
    case KEY_JSON:
        arguments->json = true;
        arguments->full = parse_json(argument, state);
        return 0;
    case ARGP_KEY_ARG:
        return ARGP_ERR_UNKNOWN; // ARGP_KEY_ARGS reads all paths together
    case ARGP_KEY_ARGS:
        arguments->first = state->next;
        if (arguments->json && state->argc - state->next > 1)
            bad_argument(state, "--json takes one result, '%s' is one too many", state->argv[state->next + 1]);
        return 0;
    case ARGP_KEY_NO_ARGS:
        require_option(state, NULL, "RESULT.h5");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int show(const char *path, const show_arguments *how) {
    whirl_result *result;
    int outcome = load_result(path, &result);
    if (outcome != EXIT_DONE) return outcome;
    if (how->json) {
        const whirl_status status =
            how->full ? whirl_result_write_json(result, stdout) : whirl_result_write_json_summary(result, stdout);
        outcome = complain_of(&status);
    } else {
        const whirl_status status = whirl_result_write_summary(result, stdout);
        outcome = complain_of(&status);
    }
    whirl_result_free(result);
    return outcome;
}

static int show_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = show_parse,
        .args_doc = "RESULT.h5...",
        .doc = "Prints the summary that `whirl run` printed: regimes, radii, rubs and confidence of the verdicts; "
               "modes, critical speeds and largest responses of machines at rest.",
    };
    show_arguments arguments = {.first = argc};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    int outcome = EXIT_DONE;
    for (int i = arguments.first; i < argc; i++) {
        if (i > arguments.first) putchar('\n');
        const int shown = show(argv[i], &arguments);
        if (shown != EXIT_DONE) outcome = shown;
    }
    const int written = finish_output();
    return outcome == EXIT_DONE ? written : outcome;
}

const command show_command = {"show", "print the summary of a result", show_run};
