/// whirl export: a result as CSV or as a MAT file.
#include "command.h"

#include <stdio.h>
#include <sys/stat.h>

#include "files.h"
#include "guard.h"
#include "output.h"

enum { KEY_FORCE = 0x100 };

typedef struct export_arguments {
    const char *result, *csv, *mat;
    bool force;
} export_arguments;

static const struct argp_option options[] = {
    {.name = "csv", .key = 'c', .arg = "DIR", .doc = "Folder for the CSV files; created if needed"},
    {.name = "mat", .key = 'm', .arg = "FILE", .doc = "MAT file for MATLAB and Octave"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace existing files"},
    {0},
};

static error_t export_parse(int key, char *argument, struct argp_state *state) {
    export_arguments *arguments = state->input;
    switch (key) {
    case 'c':
        arguments->csv = argument;
        return 0;
    case 'm':
        arguments->mat = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->result) bad_argument(state, "takes one result, '%s' is one too many", argument);
        arguments->result = argument;
        return 0;
    // Check the required arguments.
    case ARGP_KEY_END:
        require_option(state, arguments->result, "RESULT.h5");
        if (!arguments->mat) require_option(state, arguments->csv, "--csv DIR or --mat FILE");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/// Returns true if `path` may be written; otherwise reports an error. Devices and pipes may always be written.
static bool may_write(const char *path, const export_arguments *arguments) {
    struct stat there;
    if (!path) return true;
    const bool ordinary = stat(path, &there) != 0 || S_ISREG(there.st_mode);
    return may_write_file(path, arguments->result, "the result itself, expected another file",
                          arguments->force || !ordinary);
}

static int export_csv(const export_arguments *arguments) {
    whirl_result *result = NULL;
    char found[4096];
    const int outcome = load_result(arguments->result, &result);
    if (outcome != EXIT_DONE) return outcome;
    const bool kept = !arguments->force && whirl_result_find_csv(result, arguments->csv, found, sizeof found);
    if (kept) complain("'%s' is there already and is kept: add --force to replace it", found);
    const whirl_status status = kept ? whirl_ok() : whirl_result_export_csv(result, arguments->csv);
    whirl_result_free(result);
    return kept ? EXIT_FAILED : complain_of(&status);
}

/// Writes the MAT file, after a check that everything in the result but its numbers is valid.
static int export_mat(const export_arguments *arguments) {
    whirl_result *outline = NULL;
    const int outcome = load_outline(arguments->result, &outline);
    if (outcome != EXIT_DONE) return outcome;
    whirl_result_free(outline);
    guard_output(arguments->mat);
    const whirl_status status = whirl_result_export_mat(arguments->result, arguments->mat);
    return complain_of(&status);
}

static int export_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = export_parse,
        .args_doc = "RESULT.h5 --csv DIR\nRESULT.h5 --mat FILE",
        .doc = "Writes every table of a result as CSV files, units in the headings; or all of it as a MAT file for "
               "MATLAB and Octave.",
    };
    export_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    if (arguments.csv && !output_may_be_folder(arguments.csv)) return EXIT_FAILED;
    if (!may_write(arguments.mat, &arguments)) return EXIT_FAILED;
    keep_private(arguments.result);
    const int outcome = arguments.csv ? export_csv(&arguments) : EXIT_DONE;
    return outcome == EXIT_DONE && arguments.mat ? export_mat(&arguments) : outcome;
}

const command export_command = {"export", "write a result for spreadsheets, MATLAB or Octave", export_run};
