/// whirl table: prints statements and sheets of a result, or writes them to files.
#include "command.h"

#include <stdio.h>
#include <string.h>

#include "files.h"
#include "output.h"
#include "whirl/handles.h"
#include "whirl/internal/findings.h"

enum { KEY_FORCE = 0x100, KEY_LIST, KEY_FORMAT, KEY_UNITS };

typedef struct table_arguments {
    const char *result, *sheet, *output, *format, *units;
    bool force, list;
} table_arguments;

static const struct argp_option options[] = {
    {.name = "list", .key = KEY_LIST, .doc = "Print the names and titles of the result's sheets"},
    {.name = "output",
     .key = 'o',
     .arg = "FILE",
     .doc = "File to write, in the format of its ending: .txt, .csv, "
            ".tex, .md or .json; without it, or -, standard output"},
    {.name = "format",
     .key = KEY_FORMAT,
     .arg = "FORMAT",
     .doc = "text, csv, latex, markdown or json (default: by the ending of FILE, else text)"},
    {.name = "units", .key = KEY_UNITS, .arg = "UNITS", .doc = "Units of numbers, such as 'um, rpm, Hz, p-p' or US"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace an existing file"},
    {0},
};

/// The formats, and the endings of their files.
static const char *const formats[][2] = {
    {"text", ".txt"}, {"csv", ".csv"}, {"latex", ".tex"}, {"markdown", ".md"}, {"json", ".json"}};
enum { FORMATS = sizeof formats / sizeof *formats };

static error_t table_parse(int key, char *argument, struct argp_state *state) {
    table_arguments *arguments = state->input;
    whirl_sheet_form form;
    switch (key) {
    case KEY_LIST:
        arguments->list = true;
        return 0;
    case 'o':
        arguments->output = argument;
        return 0;
    case KEY_FORMAT:
        if (whirl_sheet_form_of(argument, &form).code != WHIRL_OK)
            bad_argument(state, "--format is '%s', expected text, csv, latex, markdown or json", argument);
        arguments->format = argument;
        return 0;
    case KEY_UNITS:
        arguments->units = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    // Take the result, then the name of the sheet.
    case ARGP_KEY_ARG:
        if (arguments->result && arguments->sheet)
            bad_argument(state, "takes a result and the name of a sheet, '%s' is one too many", argument);
        *(arguments->result ? &arguments->sheet : &arguments->result) = argument;
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->result, "RESULT.h5");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int complain_of_nothing(const table_arguments *arguments) {
    complain("'%s' has no statements and no sheets: 'whirl show' sums its motions up", arguments->result);
    return EXIT_BAD_INPUT;
}

static int print_names(const whirl_result *result, const table_arguments *arguments) {
    char *lines;
    const whirl_status status = whirl_result_sheets(result, arguments->units, &lines);
    if (status.code != WHIRL_OK) return complain_of(&status);
    for (const char *line = lines; *line; line += strcspn(line, "\n") + 1) {
        const int name = (int)strcspn(line, "\t"), all = (int)strcspn(line, "\n");
        printf("%-32.*s %.*s\n", name, line, all - name - 1, line + name + 1);
    }
    const bool none = !*lines;
    whirl_text_free(lines);
    return none ? complain_of_nothing(arguments) : EXIT_DONE;
}

/// Returns the requested format, or that of the file's ending; NULL, after reporting it, for an unknown one.
static const char *format_of(const table_arguments *arguments, bool printed) {
    if (arguments->format) return arguments->format;
    if (printed) return formats[0][0];
    const char *const slash = strrchr(arguments->output, '/');
    const char *const ending = strrchr(slash ? slash : arguments->output, '.');
    for (size_t i = 0; ending && i < FORMATS; i++)
        if (strcmp(ending, formats[i][1]) == 0) return formats[i][0];
    complain("'%s' ends in no format of sheets, expected .txt, .csv, .tex, .md or .json", arguments->output);
    return NULL;
}

static int write(const whirl_result *result, const table_arguments *arguments) {
    const bool printed = !arguments->output || strcmp(arguments->output, "-") == 0;
    const char *const format = format_of(arguments, printed);
    char *text;
    if (!format) return EXIT_BAD_INPUT;
    const whirl_status status = whirl_result_findings(result, arguments->sheet, arguments->units, format, &text);
    if (status.code != WHIRL_OK) return complain_of(&status);
    int outcome = EXIT_DONE;
    if (!*text)
        outcome = complain_of_nothing(arguments);
    else if (printed)
        fputs(text, stdout);
    else if (!may_write_file(arguments->output, arguments->result, "the result itself, expected another file",
                             arguments->force))
        outcome = EXIT_FAILED;
    else
        outcome = write_whole(arguments->output, arguments->force, text);
    whirl_text_free(text);
    return outcome;
}

static int act(const whirl_result *result, const void *given) {
    const table_arguments *arguments = given;
    return arguments->list ? print_names(result, arguments) : write(result, arguments);
}

static int table_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = table_parse,
        .args_doc = "RESULT.h5 [SHEET]\nRESULT.h5 --list",
        .doc = "Prints or writes the findings about machines at rest, branches, tori and spectra: all statements and "
               "sheets, or one sheet, a table of the report, with its numbers in the units of the case. TABLE/SHEET is "
               "the sheet of that table.",
    };
    table_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    return read == EXIT_DONE ? with_result(arguments.result, act, &arguments) : read;
}

const command table_command = {"table", "print or write tables of findings", table_run};
