#include "study_arguments.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "journal.h"

void note_command_line(study_arguments *arguments, int argc, char **argv) {
    char *text = arguments->command_line;
    const size_t size = sizeof arguments->command_line;
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < argc && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? " " : "", argv[i]);
}

/// Reads a budget, a number above 0 of revolutions or a time; returns all zero for other texts.
static whirl_budget read_budget(const char *text) {
    static const struct {
        const char *name;
        double seconds;
    } units[] = {{"", 0}, {"revolutions", 0}, {"s", 1}, {"min", 60}, {"h", 3600}};
    char *end = NULL;
    const double amount = strtod(text, &end);
    const char *unit = end + strspn(end, " ");
    for (size_t i = 0; i < sizeof units / sizeof *units && end > text; i++)
        if (amount > 0 && isfinite(amount) && strcmp(unit, units[i].name) == 0)
            return units[i].seconds > 0 ? (whirl_budget){.seconds = amount * units[i].seconds}
                                        : (whirl_budget){.revolutions = amount};
    return (whirl_budget){0};
}

static whirl_budget parse_budget(const char *text, const struct argp_state *state) {
    const whirl_budget budget = read_budget(text);
    if (budget.revolutions == 0 && budget.seconds == 0)
        bad_argument(state, "--refine is '%s', expected a number above 0 of revolutions, or with s, min or h of time",
                     text);
    return budget;
}

static double parse_time(const char *text, const struct argp_state *state) {
    const double seconds = read_budget(text).seconds;
    if (seconds == 0)
        bad_argument(state, "--max-time is '%s', expected a time above 0 with its unit, s, min or h", text);
    return seconds;
}

whirl_share parse_share(const char *text, const struct argp_state *state) {
    whirl_share share;
    if (!read_share(text, "/", &share))
        bad_argument(state, "--shard is '%s', expected I/N, the I-th of N shards, as in 1/7 to 7/7", text);
    return share;
}

/// Sets the default name of the result: the case's name with .h5, in the current folder.
void name_output(study_arguments *arguments, const struct argp_state *state) {
    const size_t length = strlen(arguments->given.path);
    if (arguments->output) return;
    if (is_standard_input(arguments->given.path))
        bad_argument(state, "a case from standard input has no name for its result, expected -o RESULT.h5");
    const bool short_ending = length > 4 && strcmp(arguments->given.path + length - 4, ".yml") == 0;
    char name[STUDY_PATH_SIZE - 4];
    base_name(arguments->given.path, short_ending ? ".yml" : ".yaml", name, sizeof name);
    snprintf(arguments->default_output, sizeof arguments->default_output, "%s.h5", name);
    arguments->output = arguments->default_output;
}

error_t parse_study_argument(study_arguments *arguments, int key, char *argument, struct argp_state *state) {
    switch (key) {
    case 'o':
        arguments->output = argument;
        return 0;
    case 'q':
        arguments->quiet = true;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case KEY_JSON:
        arguments->json = true;
        arguments->json_full = parse_json(argument, state);
        return 0;
    case KEY_REFINE:
        arguments->refine = true;
        if (argument) arguments->budget = parse_budget(argument, state);
        return 0;
    case KEY_MAX_TIME:
        arguments->max_time = parse_time(argument, state);
        return 0;
    default:
        return parse_case_argument(&arguments->given, key, argument, state);
    }
}
