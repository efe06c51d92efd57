/// whirl run: computes the study of a case, or a share of it.
#include "command.h"

#include "files.h"
#include "ranks.h"
#include "study.h"

enum { KEY_RESUME = KEY_STUDY_OWN, KEY_SHARD };

static const struct argp_option options[] = {
    OUTPUT_OPTION,
    SET_OPTION,
    {.name = "threads",
     .key = KEY_THREADS,
     .arg = "N",
     .doc = "Compute on N threads (default: all cores, or a rank's part of them); the result is the same for every N"},
    JSON_OPTION(KEY_JSON,
                "Print the points as one JSON document on standard output; a result file is then written only with -o"),
    {.name = "resume",
     .key = KEY_RESUME,
     .doc = "Continue an unfinished run from RESULT.h5.journal and the journals of its shards; the result is that of "
            "an uninterrupted run"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace an existing result"},
    REFINE_OPTION,
    {.name = "shard",
     .key = KEY_SHARD,
     .arg = "I/N",
     .doc = "Compute the I-th of N shards of the points, from 1/N to N/N, as one task of an array of jobs, and keep "
            "them in a journal of the shard; 'whirl merge' makes the result"},
    {.name = "max-time",
     .key = KEY_MAX_TIME,
     .arg = "TIME",
     .doc = "Stop after TIME, as in --max-time='10 min' (s, min or h), as Ctrl-C, SIGTERM and SIGUSR1 do: with a "
            "partial result of the finished points and exit status 3; --resume continues"},
    {.name = "quiet", .key = 'q', .doc = "No progress and no summary"},
    {0},
};

static void check_arguments(study_arguments *arguments, const struct argp_state *state) {
    if (!arguments->output && arguments->json && arguments->resume)
        bad_argument(state, "--resume needs the name of the result, -o RESULT.h5");
    if (arguments->json && arguments->share.count > 0)
        bad_argument(state, "--json and --shard exclude each other: 'whirl merge' prints the points of shards");
    if (ranks_count() > 1 && arguments->share.count > 0)
        bad_argument(state, "--shard excludes several ranks, which share the points of a study already");
    if (ranks_count() > 1 && is_standard_input(arguments->given.path))
        bad_argument(state, "several ranks cannot read a case from standard input, expected CASE.yaml");
    if (ranks_count() > 1 && arguments->json && !arguments->output)
        bad_argument(state, "several ranks need the name of the result, -o RESULT.h5");
    if (!arguments->json) name_output(arguments, state);
}

static error_t run_parse(int key, char *argument, struct argp_state *state) {
    study_arguments *arguments = state->input;
    switch (key) {
    case KEY_RESUME:
        arguments->resume = true;
        return 0;
    case KEY_SHARD:
        arguments->share = parse_share(argument, state);
        return 0;
    case ARGP_KEY_END:
        parse_study_argument(arguments, key, argument, state);
        check_arguments(arguments, state);
        return 0;
    default:
        return parse_study_argument(arguments, key, argument, state);
    }
}

static int run_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = run_parse,
        .args_doc = "CASE.yaml",
        .doc = "Computes the study of a case and writes the result as one HDF5 file. A motion that diverges is a "
               "result and not a failure. CASE.yaml may be - for standard input.",
    };
    study_arguments arguments = {.given.threads = ranks_threads()};
    return study_command(&argp, argc, argv, &arguments);
}

const command run_command = {"run", "compute the study of a case", run_run};
