/// whirl merge: makes the result from the journals of shards.
#include "command.h"

#include "cores.h"
#include "study.h"

static const struct argp_option options[] = {
    OUTPUT_OPTION,
    SET_OPTION,
    {.name = "threads",
     .key = KEY_THREADS,
     .arg = "N",
     .doc = "Use N threads (default: all cores); the result is the same for every N"},
    JSON_OPTION(KEY_JSON, "Print the points as one JSON document on standard output, too"),
    {.name = "force", .key = KEY_FORCE, .doc = "Replace an existing result"},
    REFINE_OPTION,
    {.name = "max-time",
     .key = KEY_MAX_TIME,
     .arg = "TIME",
     .doc = "Stop after TIME, as in --max-time='10 min' (s, min or h); the same command continues"},
    {.name = "quiet", .key = 'q', .doc = "No progress and no summary"},
    {0},
};

static void take_journal(study_arguments *arguments, char *path, const struct argp_state *state) {
    if (arguments->journal_count == MAX_JOURNALS) bad_argument(state, "takes at most %d journals", MAX_JOURNALS);
    arguments->journals[arguments->journal_count++] = path;
}

static error_t merge_parse(int key, char *argument, struct argp_state *state) {
    study_arguments *arguments = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        if (!arguments->given.path) return parse_study_argument(arguments, key, argument, state);
        take_journal(arguments, argument, state);
        return 0;
    case ARGP_KEY_END:
        parse_study_argument(arguments, key, argument, state);
        name_output(arguments, state);
        return 0;
    default:
        return parse_study_argument(arguments, key, argument, state);
    }
}

static int merge(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = merge_parse,
        .args_doc = "CASE.yaml [JOURNAL...]",
        .doc = "Makes the result of the shards of 'whirl run', from all journals of the run in the folder of "
               "RESULT.h5, and from the named ones. Case and settings must be those of the shards. It computes no "
               "points of the study: if some are missing the result is partial and the exit status 3. It does compute "
               "copies of chaotic motions and refinement, which need all points.",
    };
    study_arguments arguments = {.given.threads = available_cores(), .merge = true};
    return study_command(&argp, argc, argv, &arguments);
}

const command merge_command = {"merge", "make the result of the shards of a run", merge};
