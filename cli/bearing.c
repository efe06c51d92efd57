/// whirl bearing: a journal bearing by itself, over load and speed.
#include "command.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "case_arguments.h"
#include "cores.h"
#include "files.h"
#include "found.h"
#include "guard.h"
#include "interrupt.h"
#include "output.h"
#include "progress.h"
#include "whirl/engine/figure.h"
#include "whirl/internal/bearing_table.h"

enum { KEY_FORCE = KEY_OWN, KEY_CSV, KEY_TABLE, KEY_OVER, KEY_AT, KEY_FIGURE, KEY_GNUPLOT, MAX_THREADS = 1024 };

typedef struct bearing_arguments {
    const char *path, *csv, *table, *station, *output, *figure, *gnuplot;
    int threads;
    bool json, force, quiet, over_frequency;
    found_arguments found;
} bearing_arguments;

static const struct argp_option options[] = {
    {.name = "json", .key = 'j', .doc = "Print all numbers as JSON, in SI and radians"},
    FOUND_OPTIONS,
    {.name = "csv", .key = KEY_CSV, .arg = "FILE", .doc = "Write the table as CSV, in SI and radians"},
    {.name = "table",
     .key = KEY_TABLE,
     .arg = "FILE",
     .doc = "Write the coefficients over the speed as an element `bearing` for the list of elements of a case"},
    {.name = "over-frequency",
     .key = KEY_OVER,
     .doc = "With --table and tilting pads: coefficients over the frequency of whirl, too, from 0 to the highest "
            "speed; otherwise those of one whirl ratio, for synchronous responses"},
    {.name = "at", .key = KEY_AT, .arg = "STATION", .doc = "Station of the element of --table (default: journal)"},
    {.name = "output", .key = 'o', .arg = "FILE", .doc = "Write a figure: FILE.png, .pdf, .svg or .json"},
    {.name = "figure",
     .key = KEY_FIGURE,
     .arg = "NAME",
     .doc = "Figure to write: curves (default), sommerfeld or locus"},
    {.name = "gnuplot", .key = KEY_GNUPLOT, .arg = "PROGRAM", .doc = "gnuplot program (default: the one on the PATH)"},
    {.name = "threads", .key = KEY_THREADS, .arg = "N", .doc = "Number of threads (default: one a core)"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace existing files"},
    {.name = "quiet", .key = 'q', .doc = "Show no progress"},
    {0}};

static error_t bearing_parse(int key, char *argument, struct argp_state *state) {
    bearing_arguments *arguments = state->input;
    switch (key) {
    case 'j':
        arguments->json = true;
        return 0;
    case 'q':
        arguments->quiet = true;
        return 0;
    case 'o':
        arguments->output = argument;
        return 0;
    case KEY_CSV:
        arguments->csv = argument;
        return 0;
    case KEY_TABLE:
        arguments->table = argument;
        return 0;
    case KEY_OVER:
        arguments->over_frequency = true;
        return 0;
    case KEY_AT:
        arguments->station = argument;
        return 0;
    case KEY_FIGURE:
        arguments->figure = argument;
        return 0;
    case KEY_GNUPLOT:
        arguments->gnuplot = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case KEY_THREADS:
        arguments->threads = take_whole("--threads", argument, MAX_THREADS, state);
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->path) bad_argument(state, "takes one FILE, '%s' is one too many", argument);
        arguments->path = argument;
        return 0;
    // Check options that need others.
    case ARGP_KEY_END:
        require_option(state, arguments->path, "FILE.yaml");
        if (arguments->over_frequency && !arguments->table)
            bad_argument(state, "--over-frequency needs --table, the file of the element");
        if (arguments->figure && !arguments->output) bad_argument(state, "--figure needs -o, the file of the figure");
        found_check(&arguments->found, state);
        return 0;
    default:
        return found_take(key, argument, state, &arguments->found) ? 0 : ARGP_ERR_UNKNOWN;
    }
}

/// Returns true if all output files may be written; otherwise reports an error. Called before anything is computed.
static bool may_write(const bearing_arguments *arguments) {
    const char *const paths[] = {arguments->csv, arguments->table, arguments->output};
    bool may = true;
    for (size_t i = 0; i < sizeof paths / sizeof *paths && may; i++)
        may = !paths[i] || may_write_file(paths[i], arguments->path, "the file that is read, expected another one",
                                          arguments->force);
    return may;
}

/// Writes the table as an element at `station`, or, if that is NULL, as CSV, whose warnings are in `units`.
static int write_file(const whirl_bearing_table *table, const char *path, const char *station, bool over_frequency,
                      const char *units) {
    FILE *stream = fopen(path, "w");
    if (!stream) {
        complain("'%s' cannot be written", path);
        return EXIT_FAILED;
    }
    const whirl_status status = station ? whirl_bearing_write_element(table, station, over_frequency, stream)
                                        : whirl_bearing_write_csv(table, units, stream);
    const bool closed = fclose(stream) == 0;
    if (status.code != WHIRL_OK || !closed) remove(path);
    if (status.code != WHIRL_OK) return complain_of(&status);
    if (!closed) complain("'%s' cannot be written", path);
    return closed ? EXIT_DONE : EXIT_FAILED;
}

static int write_figure(const whirl_bearing_table *table, const bearing_arguments *arguments) {
    whirl_figure *figure;
    whirl_status status = whirl_bearing_figure(table, arguments->figure, arguments->found.units, &figure);
    if (status.code != WHIRL_OK) return complain_of(&status);
    guard_output(arguments->output);
    status = whirl_figure_write(figure, arguments->output, arguments->gnuplot);
    whirl_figure_free(figure);
    return complain_of(&status);
}

static int print(const whirl_bearing_table *table, const bearing_arguments *arguments) {
    const char *const units = arguments->found.units;
    whirl_findings *findings;
    whirl_status status = whirl_ok();
    if (arguments->json) {
        status = whirl_bearing_write_json(table, units, stdout);
        return status.code == WHIRL_OK ? finish_output() : complain_of(&status);
    }
    status = whirl_bearing_findings(table, units, &findings);
    if (status.code != WHIRL_OK) return complain_of(&status);
    const int outcome = found_print(findings, table->bearing->title, &arguments->found);
    whirl_findings_free(findings);
    return outcome;
}

static int write_all(const whirl_bearing_table *table, const bearing_arguments *arguments) {
    int outcome = print(table, arguments);
    if (outcome == EXIT_DONE && arguments->csv)
        outcome = write_file(table, arguments->csv, NULL, false, arguments->found.units);
    if (outcome == EXIT_DONE && arguments->table)
        outcome = write_file(table, arguments->table, arguments->station ? arguments->station : "journal",
                             arguments->over_frequency, NULL);
    if (outcome == EXIT_DONE && arguments->output) outcome = write_figure(table, arguments);
    return outcome;
}

static int bearing(const bearing_arguments *arguments, const whirl_bearing *of) {
    whirl_bearing_table *table;
    progress_view view = progress_begin();
    const whirl_bearing_options how = {.threads = arguments->threads ? arguments->threads : available_cores(),
                                       .progress = arguments->quiet ? NULL : progress_show,
                                       .context = &view,
                                       .stop = interrupt_watch()};
    const whirl_status status = whirl_bearing_solve(of, &how, &table);
    progress_end(&view);
    if (status.code == WHIRL_STOPPED) complain("%s (%s)", status.message, interrupt_text());
    if (status.code != WHIRL_OK) return status.code == WHIRL_STOPPED ? EXIT_UNFINISHED : complain_of(&status);
    const int outcome = write_all(table, arguments);
    whirl_bearing_table_free(table);
    return outcome;
}

static int bearing_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = bearing_parse,
        .args_doc = "FILE.yaml",
        .doc = "Computes a journal bearing by itself, over load and speed: eccentricity, attitude, stiffness, damping, "
               "film, flow, power. Pads have finite length and are fixed or tilting. `whirl describe bearing_file` and "
               "`pad` list the keys of FILE.",
    };
    bearing_arguments arguments = {.path = NULL};
    whirl_problems problems = {0};
    whirl_bearing *of;
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    const whirl_status status = whirl_bearing_load(arguments.path, &problems, &of);
    if (status.code != WHIRL_OK) return complain_of_problems(&problems, &status);
    const int outcome = may_write(&arguments) ? bearing(&arguments, of) : EXIT_FAILED;
    whirl_bearing_free(of);
    return outcome;
}

const command bearing_command = {"bearing", "compute a journal bearing by itself", bearing_run};
