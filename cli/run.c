/// whirl run: computes the study of a case.
#include "command.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "case_arguments.h"
#include "cores.h"
#include "guard.h"
#include "interrupt.h"
#include "journal.h"
#include "output.h"
#include "progress.h"
#include "summary.h"

enum { PATH_SIZE = 4096, FACT_SIZE = 256 };

typedef struct run_arguments {
    case_arguments given;
    const char *output;
    bool json, quiet, resume, force, refine;
    whirl_budget budget; ///< of refinement; all zero: as many revolutions as the study has
    char default_output[PATH_SIZE];
} run_arguments;

// ---------------------------------------------------------------- arguments

enum { KEY_JSON = KEY_OWN, KEY_RESUME, KEY_FORCE, KEY_REFINE };

static const struct argp_option options[] = {
    {.name = "output",
     .key = 'o',
     .arg = "RESULT.h5",
     .doc = "Write the result here (default: the case's name with .h5, in the current folder)"},
    SET_OPTION,
    {.name = "threads",
     .key = KEY_THREADS,
     .arg = "N",
     .doc = "Compute on N threads (default: all cores); the result is the same for every N"},
    {.name = "json",
     .key = KEY_JSON,
     .doc = "Print the points as one JSON document on standard output; a result file is then written only with -o"},
    {.name = "resume",
     .key = KEY_RESUME,
     .doc = "Go on with a run that did not finish, from RESULT.h5.journal; the result is that of an uninterrupted run"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace a result that is there already; without it a result is kept"},
    {.name = "refine",
     .key = KEY_REFINE,
     .arg = "BUDGET",
     .flags = OPTION_ARG_OPTIONAL,
     .doc =
         "Do points again whose verdict is undetermined or of low confidence, as the verdict advises (longer, or with "
         "a tighter tolerance), until BUDGET is spent: revolutions, as in --refine=2e6, or time, as in --refine='10 "
         "min' "
         "(default: as many revolutions as the study has)"},
    {.name = "quiet", .key = 'q', .doc = "No progress and no summary"},
    {0},
};

/// A number above 0, of revolutions or of a time.
static whirl_budget parse_budget(const char *text, const struct argp_state *state) {
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
    bad_argument(state, "--refine is '%s', expected a number above 0 of revolutions, or with s, min or h of time",
                 text);
    return (whirl_budget){0};
}

/// The case's name with .h5, in the current folder.
static void name_output(run_arguments *arguments) {
    const size_t length = strlen(arguments->given.path);
    const bool short_ending = length > 4 && strcmp(arguments->given.path + length - 4, ".yml") == 0;
    char name[PATH_SIZE - 4];
    base_name(arguments->given.path, short_ending ? ".yml" : ".yaml", name, sizeof name);
    snprintf(arguments->default_output, sizeof arguments->default_output, "%s.h5", name);
    arguments->output = arguments->default_output;
}

static error_t parse(int key, char *argument, struct argp_state *state) {
    run_arguments *arguments = state->input;
    switch (key) {
    case 'o':
        arguments->output = argument;
        return 0;
    case 'q':
        arguments->quiet = true;
        return 0;
    case KEY_JSON:
        arguments->json = true;
        return 0;
    case KEY_RESUME:
        arguments->resume = true;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case KEY_REFINE:
        arguments->refine = true;
        if (argument) arguments->budget = parse_budget(argument, state);
        return 0;
    case ARGP_KEY_END:
        parse_case_argument(&arguments->given, key, argument, state);
        if (!arguments->output && arguments->json && arguments->resume)
            bad_argument(state, "--resume needs the name of the result, -o RESULT.h5");
        if (!arguments->output && !arguments->json) name_output(arguments);
        return 0;
    default:
        return parse_case_argument(&arguments->given, key, argument, state);
    }
}

// ---------------------------------------------------------------- from case to result

static int set_budget(const run_arguments *arguments, whirl_case *object) {
    whirl_study study;
    whirl_budget budget = arguments->budget;
    const whirl_status status = whirl_case_study(object, &study);
    if (status.code != WHIRL_OK) return complain_of(&status);
    if (budget.revolutions == 0 && budget.seconds == 0) budget.revolutions = whirl_study_revolutions(&study);
    whirl_case_refine(object, budget);
    return EXIT_DONE;
}

static int load(const run_arguments *arguments, whirl_case **object) {
    const int outcome = load_case(&arguments->given, object);
    return outcome == EXIT_DONE && arguments->refine ? set_budget(arguments, *object) : outcome;
}

/// Whatever the exit status, there may be a result, of what was done until a stop.
static int compute(const run_arguments *arguments, const whirl_case *object, whirl_journal *journal,
                   whirl_result **result) {
    progress_view view = progress_begin();
    const whirl_run_options how = {
        .threads = arguments->given.threads,
        .progress = arguments->quiet ? NULL : progress_show,
        .context = &view,
        .stop = interrupt_watch(),
        .keeper = journal ? whirl_journal_keeper(journal) : NULL,
    };
    const whirl_status status = whirl_case_run(object, &how, result);
    progress_end(&view);
    if (status.code != WHIRL_STOPPED) return complain_of(&status);
    complain("%s (%s)", status.message, interrupt_text());
    return EXIT_FAILED;
}

// ---------------------------------------------------------------- how it was computed

static void now_text(char *text, size_t size) {
    const time_t now = time(NULL);
    struct tm parts;
    if (!gmtime_r(&now, &parts) || strftime(text, size, "%Y-%m-%dT%H:%M:%SZ", &parts) == 0) text[0] = '\0';
}

static void join(int argc, char **argv, char *text, size_t size) {
    size_t used = 0;
    text[0] = '\0';
    for (int i = 0; i < argc && used < size; i++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? " " : "", argv[i]);
}

static whirl_status add_facts(whirl_result *result, const char *const facts[][2], size_t count) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++)
        status = whirl_result_add_fact(result, facts[i][0], facts[i][1]);
    return status;
}

// ---------------------------------------------------------------- output

/// Writes the result and makes sure of it.
static int save(const run_arguments *arguments, const whirl_result *result) {
    char half_written[PATH_SIZE + 32];
    snprintf(half_written, sizeof half_written, "%s.tmp-%ld", arguments->output, (long)getpid());
    guard_file(half_written);
    whirl_status status = whirl_result_write(result, arguments->output);
    if (status.code == WHIRL_OK) status = whirl_result_verify(result, arguments->output);
    if (status.code == WHIRL_OK) return EXIT_DONE;
    complain_of(&status);
    return EXIT_FAILED;
}

static int show(const run_arguments *arguments, const whirl_result *result) {
    if (arguments->json) {
        const whirl_status status = whirl_result_write_json(result, stdout);
        if (status.code != WHIRL_OK) return complain_of(&status);
    } else if (!arguments->quiet) {
        summarize_result(result);
        printf("%s\n", arguments->output);
    }
    return finish_output();
}

/// Whether a partial result would cover the complete one of an earlier run.
static bool would_cover(const char *path, const whirl_result *result) {
    size_t done, total;
    whirl_result *earlier = NULL;
    if (!path || !whirl_result_partial(result, &done, &total)) return false;
    const bool complete =
        whirl_result_read_outline(path, &earlier).code == WHIRL_OK && !whirl_result_partial(earlier, &done, &total);
    whirl_result_free(earlier);
    return complete;
}

/// The journal goes only when a complete result is safe.
static void end_journal(const run_arguments *arguments, whirl_journal *journal, bool safe) {
    if (!safe) {
        leave_journal(arguments->output, journal);
    } else if (journal) {
        const whirl_status status = whirl_journal_remove(journal);
        if (status.code != WHIRL_OK) complain("%s", status.message); // the result is safe all the same
    }
}

/// Saves and shows a result, which may be partial. Large tables lie in the journal: it is open until all is told.
static int deliver(const run_arguments *arguments, const whirl_result *result, whirl_journal *journal) {
    size_t done, total;
    if (would_cover(arguments->output, result)) {
        complain("'%s' holds the complete result of an earlier run and is left as it is", arguments->output);
        leave_journal(arguments->output, journal);
        return EXIT_FAILED;
    }
    const int saved = arguments->output ? save(arguments, result) : EXIT_DONE;
    const bool partial = whirl_result_partial(result, &done, &total);
    const int told = saved == EXIT_DONE ? show(arguments, result) : saved;
    if (saved == EXIT_DONE && partial && arguments->output) complain("'%s' is partial and says so", arguments->output);
    end_journal(arguments, journal, saved == EXIT_DONE && !partial);
    return told;
}

/// Computes, or takes what a journal has, and delivers.
static int run_study(const run_arguments *arguments, const whirl_case *object, whirl_journal *journal,
                     const char *command_line) {
    char started[32], finished[32], threads[16];
    whirl_result *result = NULL;
    now_text(started, sizeof started);
    const int outcome = compute(arguments, object, journal, &result);
    if (!result) {
        leave_journal(arguments->output, journal);
        return outcome;
    }
    now_text(finished, sizeof finished);
    snprintf(threads, sizeof threads, "%d", arguments->given.threads);
    const char *const facts[][2] = {
        {"command line", command_line}, {"started", started}, {"finished", finished}, {"threads", threads}};
    const whirl_status status = add_facts(result, facts, sizeof facts / sizeof *facts);
    if (status.code != WHIRL_OK) leave_journal(arguments->output, journal);
    const int delivered = status.code == WHIRL_OK ? deliver(arguments, result, journal) : complain_of(&status);
    whirl_result_free(result);
    return outcome != EXIT_DONE ? outcome : delivered;
}

static int run_case(const run_arguments *arguments, const char *command_line) {
    whirl_case *object = NULL;
    whirl_journal *journal = NULL;
    whirl_result *finished = NULL;
    interrupt_watch(); // from the start: reading a case takes time too, and a full disk sends signals at the first
                       // write
    int outcome = load(arguments, &object);
    if (outcome == EXIT_DONE && arguments->output && !output_is_writable(arguments->output, arguments->given.path))
        outcome = EXIT_FAILED;
    if (outcome == EXIT_DONE) keep_private(arguments->given.path);
    if (outcome == EXIT_DONE && arguments->output)
        outcome = open_journal(arguments->output, object, arguments->resume, arguments->force, arguments->quiet,
                               &journal, &finished);
    if (outcome == EXIT_DONE && finished)
        outcome = show(arguments, finished);
    else if (outcome == EXIT_DONE)
        outcome = run_study(arguments, object, journal, command_line);
    whirl_result_free(finished);
    whirl_case_free(object);
    return outcome;
}

static int run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = parse,
        .args_doc = "CASE.yaml",
        .doc = "Computes the study of a case and writes the result as one HDF5 file. Where a motion diverges, that is "
               "a result "
               "and not a failure.",
    };
    run_arguments arguments = {.given.threads = available_cores()};
    char command_line[FACT_SIZE]; // argp reorders argv
    join(argc, argv, command_line, sizeof command_line);
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    return run_case(&arguments, command_line);
}

const command run_command = {"run", "compute the study of a case", run};
