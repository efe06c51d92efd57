/// whirl figure: one figure of a result as a file, or their names.
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"
#include "guard.h"
#include "output.h"
#include "whirl/engine/figure.h"

enum { KEY_FORCE = 0x100, KEY_LIST, KEY_FORMAT, KEY_UNITS, KEY_LOG, KEY_PANELS, KEY_GNUPLOT, KEY_WITH, KEY_COLUMNS };

typedef struct figure_arguments {
    const char *result, *name, *output, *format, *gnuplot, *with;
    whirl_figure_options how;
    chosen_columns columns;
    bool force, list;
} figure_arguments;

static const struct argp_option options[] = {
    {.name = "list", .key = KEY_LIST, .doc = "Print the names and titles of the result's figures"},
    {.name = "output",
     .key = 'o',
     .arg = "FILE",
     .doc = "File to write (default: NAME.FORMAT); - for JSON on standard output"},
    {.name = "format",
     .key = KEY_FORMAT,
     .arg = "FORMAT",
     .doc = "png, pdf, svg or json (default: by the ending of FILE, else png)"},
    {.name = "units", .key = KEY_UNITS, .arg = "UNITS", .doc = "Units of the figure, such as 'um, rpm, Hz, p-p' or US"},
    {.name = "log", .key = KEY_LOG, .arg = "AXES", .doc = "Make these axes logarithmic: x, y or xy"},
    {.name = "panels", .key = KEY_PANELS, .arg = "NAMES", .doc = "These panels alone, such as x,exponent"},
    {.name = "with",
     .key = KEY_WITH,
     .arg = "FILE",
     .doc = "Draw the same figure of this result or record into it, dashed: a measurement over a model"},
    {.name = "columns",
     .key = KEY_COLUMNS,
     .arg = "COLUMNS",
     .doc = "Columns of a measured file, RESULT or that of --with: 'HEADING=NAME; ...' with the names in the file, "
            "'time [s]=t; keyphasor=key; de x [um]=X[:, 0]'; in a CSV file its headings, or 'column 3'"},
    {.name = "gnuplot", .key = KEY_GNUPLOT, .arg = "PROGRAM", .doc = "gnuplot program (default: the one on the PATH)"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace an existing file"},
    {0},
};

static bool is_one_of(const char *word, const char *const *words) {
    for (; *words; words++)
        if (strcmp(word, *words) == 0) return true;
    return false;
}

/// Takes the columns of a text 'HEADING=NAME; ...', which it changes.
static void figure_read_columns(char *text, chosen_columns *out, struct argp_state *state) {
    for (char *next = text; next;) {
        char *one = next, *equals = strchr(one, '='), *end = strchr(one, ';');
        next = end ? end + 1 : NULL;
        if (end) *end = '\0';
        one += strspn(one, " ");
        if (!*one && !next) break; // a text may end with ';'
        if (!equals || (end && equals > end) || equals == one || !equals[1])
            bad_argument(state, "--columns has '%s', expected HEADING=NAME, such as 'time [s]=t'", one);
        if (out->count == MAX_CHOSEN_COLUMNS)
            bad_argument(state, "--columns has more than %d columns, '%s' is one too many", MAX_CHOSEN_COLUMNS, one);
        char *last = equals;
        while (last > one && last[-1] == ' ') last--;
        *last = '\0';
        char *name = equals + 1 + strspn(equals + 1, " ");
        for (char *tail = name + strlen(name); tail > name && tail[-1] == ' ';) *--tail = '\0';
        out->headings[out->count] = one;
        out->names[out->count++] = name;
    }
}

static error_t figure_parse(int key, char *argument, struct argp_state *state) {
    static const char *const formats[] = {"png", "pdf", "svg", "json", NULL}, *const axes[] = {"x", "y", "xy", NULL};
    figure_arguments *arguments = state->input;
    switch (key) {
    case KEY_LIST:
        arguments->list = true;
        return 0;
    case 'o':
        arguments->output = argument;
        return 0;
    // Check options that take one of a few words.
    case KEY_FORMAT:
        arguments->format = argument;
        if (!is_one_of(argument, formats))
            bad_argument(state, "--format is '%s', expected png, pdf, svg or json", argument);
        return 0;
    case KEY_UNITS:
        arguments->how.units = argument;
        return 0;
    case KEY_LOG:
        arguments->how.log = argument;
        if (!is_one_of(argument, axes)) bad_argument(state, "--log is '%s', expected x, y or xy", argument);
        return 0;
    case KEY_PANELS:
        arguments->how.panels = argument;
        return 0;
    case KEY_WITH:
        arguments->with = argument;
        return 0;
    case KEY_COLUMNS:
        figure_read_columns(argument, &arguments->columns, state);
        return 0;
    case KEY_GNUPLOT:
        arguments->gnuplot = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    // Take the result, then the name of the figure.
    case ARGP_KEY_ARG:
        if (arguments->result && arguments->name)
            bad_argument(state, "takes a result and the name of a figure, '%s' is one too many", argument);
        *(arguments->result ? &arguments->name : &arguments->result) = argument;
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->result, "RESULT.h5");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int print_names(const whirl_result *result, const figure_arguments *arguments) {
    whirl_figure_name *names;
    size_t count;
    const whirl_status status = whirl_figure_names(result, arguments->how.units, &names, &count);
    for (size_t i = 0; i < count; i++) printf("%-32s %s\n", names[i].name, names[i].title);
    free(names);
    return complain_of(&status);
}

/// Writes the path of the figure; the ending of the format is added if there is none.
static void name_output(const figure_arguments *arguments, const whirl_figure *figure, char *path, size_t size) {
    const char *output = arguments->output ? arguments->output : figure->name;
    const char *last = strrchr(output, '/') ? strrchr(output, '/') : output;
    const bool named = arguments->output && strrchr(last, '.') && !arguments->format;
    snprintf(path, size, named ? "%s" : "%s.%s", output, arguments->format ? arguments->format : "png");
    const size_t length = strlen(output), ending = arguments->format ? strlen(arguments->format) : 0;
    const bool ends = ending > 0 && length > ending && output[length - ending - 1] == '.' &&
                      strcmp(output + length - ending, arguments->format) == 0;
    if (ends) snprintf(path, size, "%s", output);
}

static int write(const whirl_result *result, const figure_arguments *arguments) {
    whirl_figure *figure;
    char path[4096];
    whirl_status status = whirl_figure_new(result, arguments->name, &arguments->how, &figure);
    if (status.code != WHIRL_OK) return complain_of(&status);
    int outcome = EXIT_DONE;
    name_output(arguments, figure, path, sizeof path);
    if (arguments->output && strcmp(arguments->output, "-") == 0) {
        status = whirl_figure_write_json(figure, stdout);
        outcome = complain_of(&status);
    } else if (!may_write_file(path, arguments->result, "the result itself, expected another file", arguments->force)) {
        outcome = EXIT_FAILED;
    } else {
        guard_output(path);
        status = whirl_figure_write(figure, path, arguments->gnuplot);
        outcome = complain_of(&status);
        if (outcome == EXIT_DONE) printf("%s: %s\n", path, figure->title);
    }
    whirl_figure_free(figure);
    return outcome;
}

static int figure_act(figure_arguments *arguments) {
    whirl_result *result = NULL, *with = NULL;
    bool chosen = false;
    keep_private(arguments->result);
    int outcome = load_result_columns(arguments->result, &arguments->columns, &result, &chosen);
    if (outcome == EXIT_DONE && arguments->with && !arguments->list)
        outcome = load_result_columns(arguments->with, &arguments->columns, &with, &chosen);
    if (outcome == EXIT_DONE && arguments->columns.count > 0 && !chosen) {
        complain("--columns chooses columns of a measured file, and '%s' is a result", arguments->result);
        outcome = EXIT_BAD_INPUT;
    }
    arguments->how.with = with;
    if (outcome == EXIT_DONE) outcome = arguments->list ? print_names(result, arguments) : write(result, arguments);
    whirl_result_free(with);
    whirl_result_free(result);
    const int written = finish_output();
    return outcome == EXIT_DONE ? written : outcome;
}

static int figure_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = figure_parse,
        .args_doc = "RESULT [NAME]\nRESULT --list",
        .doc = "Writes one figure of the report of a result: a picture, or its panels, axes and series as JSON. The "
               "default is the first figure. The names FIELD[:OF][:COLUMN] ('orbit/mean:disc:y'), @VALUE[:STATION] and "
               "@#NUMBER[:STATION] make figures of any field and of any point. TABLE/NAME is the figure of that table. "
               "RESULT is a result file, or a record of a run-up or coast-down (CSV, HDF5, MAT or UFF) with the "
               "headings 'time [s]', 'keyphasor' or 'speed [rpm]', and two probes a station: 'de x [um]', or "
               "'de 45 [um]' in degrees; --columns chooses them by their names.",
    };
    figure_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    return read == EXIT_DONE ? figure_act(&arguments) : read;
}

const command figure_command = {"figure", "write one figure of a result", figure_run};
