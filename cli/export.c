/// whirl export: a result as CSV.
#include "command.h"

#include <stdio.h>

#include "files.h"
#include "output.h"

typedef struct export_arguments {
    const char *result, *csv;
} export_arguments;

static const struct argp_option options[] = {
    {.name = "csv", .key = 'c', .arg = "DIR", .doc = "Folder for the CSV files; it is made when it is not there"},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state) {
    export_arguments *arguments = state->input;
    switch (key) {
    case 'c':
        arguments->csv = argument;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->result) bad_argument(state, "takes one result, '%s' is one too many", argument);
        arguments->result = argument;
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->result, "RESULT.h5");
        require_option(state, arguments->csv, "--csv DIR");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = parse,
        .args_doc = "RESULT.h5 --csv DIR",
        .doc = "Writes every table of a result as CSV files, units in the headings.",
    };
    export_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    if (!output_may_be_folder(arguments.csv)) return EXIT_FAILED;
    keep_private(arguments.result);
    whirl_result *result = NULL;
    const int outcome = load_result(arguments.result, &result);
    if (outcome != EXIT_DONE) return outcome;
    const whirl_status status = whirl_result_export_csv(result, arguments.csv);
    whirl_result_free(result);
    return complain_of(&status);
}

const command export_command = {"export", "write a result as CSV", run};
