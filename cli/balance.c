/// whirl balance: weights that balance a rotor, from vibrations with and without trial weights.
#include "command.h"

#include <stdbool.h>
#include <stdio.h>

#include "found.h"
#include "whirl/internal/balance.h"

typedef struct balance_arguments {
    const char *path;
    bool json;
    found_arguments found;
} balance_arguments;

static const struct argp_option options[] = {
    {.name = "json", .key = 'j', .doc = "Print all numbers as JSON, in SI and radians, in the file's conventions"},
    FOUND_OPTIONS,
    {0}};

static error_t balance_parse(int key, char *argument, struct argp_state *state) {
    balance_arguments *arguments = state->input;
    switch (key) {
    case 'j':
        arguments->json = true;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->path) bad_argument(state, "takes one FILE, '%s' is one too many", argument);
        arguments->path = argument;
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->path, "FILE.yaml");
        found_check(&arguments->found, state);
        return 0;
    default:
        return found_take(key, argument, state, &arguments->found) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

static int print(const balance_arguments *arguments, const whirl_balance *of, const whirl_balance_model *model,
                 const whirl_correction *found) {
    const char *const units = arguments->found.units;
    whirl_findings *findings;
    whirl_status status = whirl_ok();
    if (arguments->json) {
        status = whirl_balance_write_json(of, model, found, units, stdout);
        return status.code == WHIRL_OK ? finish_output() : complain_of(&status);
    }
    status = whirl_balance_findings(of, model, found, units, &findings);
    if (status.code != WHIRL_OK) return complain_of(&status);
    const int outcome = found_print(findings, of->title, &arguments->found);
    whirl_findings_free(findings);
    return outcome;
}

static int balance(const balance_arguments *arguments, const whirl_balance *of) {
    whirl_problems problems = {0};
    whirl_balance_model *model;
    whirl_correction *found = NULL;
    whirl_status status = whirl_balance_consult(of, arguments->path, &problems, &model);
    if (status.code != WHIRL_OK) return complain_of_problems(&problems, &status);
    whirl_problems_free(&problems);
    status = whirl_balance_solve(of, model, &found);
    const int outcome = status.code == WHIRL_OK ? print(arguments, of, model, found) : complain_of(&status);
    whirl_correction_free(found);
    whirl_balance_model_free(model);
    return outcome;
}

static int balance_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = balance_parse,
        .args_doc = "FILE.yaml",
        .doc = "Finds the weights that balance a rotor from vibrations measured with and without trial weights, by "
               "influence coefficients: several planes, speeds and probes, least squares. Sets of weights balance mode "
               "by mode. A model, a case of the rotor, replaces trial weights or proposes them. `whirl describe "
               "balance` lists the keys of FILE.",
    };
    balance_arguments arguments = {.path = NULL};
    whirl_problems problems = {0};
    whirl_balance *of;
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    const whirl_status status = whirl_balance_load(arguments.path, &problems, &of);
    if (status.code != WHIRL_OK) return complain_of_problems(&problems, &status);
    const int outcome = balance(&arguments, of);
    whirl_balance_free(of);
    return outcome;
}

const command balance_command = {"balance", "find the weights that balance a rotor", balance_run};
