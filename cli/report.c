/// whirl report: draws the figures of results and writes pages.
#include "command.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "files.h"
#include "output.h"

typedef struct report_arguments {
    char **results; ///< paths, borrowed from argv
    size_t count;
    const char *directory, *claims, *gnuplot, *weasyprint, *explorer, *units;
    bool lateral, torsional, quiet, force;
} report_arguments;

/// A result, and the name of its folder in the report.
typedef struct entry {
    whirl_result *result;
    char name[WHIRL_NAME_SIZE];
} entry;

enum {
    KEY_CLAIMS = 256,
    KEY_GNUPLOT,
    KEY_EXPLORER,
    KEY_LATERAL,
    KEY_TORSIONAL,
    KEY_WEASYPRINT,
    KEY_UNITS,
    KEY_FORCE,
    PATH_SIZE = 4096
};

static const struct argp_option options[] = {
    {.name = "output", .key = 'o', .arg = "DIR", .doc = "Folder for the report; created if needed"},
    {.name = "claims",
     .key = KEY_CLAIMS,
     .arg = "FILE",
     .doc = "Compare the results with the claims of a paper or a measurement"},
    {.name = "gnuplot",
     .key = KEY_GNUPLOT,
     .arg = "PROGRAM",
     .doc = "Draw with this gnuplot (default: the one on the PATH)"},
    {.name = "explorer",
     .key = KEY_EXPLORER,
     .arg = "FILE",
     .doc = "Template of explorer.html (default: the one that `make explorer` built or that is installed)"},
    {.name = "units",
     .key = KEY_UNITS,
     .arg = "LIST",
     .doc =
         "Units of figures and pages, such as \"um, rpm, Hz, p-p\" or US (default: those of the case); `whirl describe "
         "study` lists them"},
    {.name = "lateral",
     .key = KEY_LATERAL,
     .doc = "Also write lateral.html and lateral.pdf: a lateral analysis, from the machine to margins and stability"},
    {.name = "torsional",
     .key = KEY_TORSIONAL,
     .doc = "Also write torsional.html and torsional.pdf: a torsional analysis, from the train to starts and fatigue"},
    {.name = "weasyprint",
     .key = KEY_WEASYPRINT,
     .arg = "PROGRAM",
     .doc = "Make these PDFs with this weasyprint (default: the one on the PATH)"},
    {.name = "force", .key = KEY_FORCE, .doc = "Replace existing files"},
    {.name = "quiet", .key = 'q', .doc = "Print errors only"},
    {0},
};

static error_t report_parse(int key, char *argument, struct argp_state *state) {
    report_arguments *arguments = state->input;
    switch (key) {
    case 'o':
        arguments->directory = argument;
        return 0;
    case 'q':
        arguments->quiet = true;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case KEY_CLAIMS:
        arguments->claims = argument;
        return 0;
    case KEY_GNUPLOT:
        arguments->gnuplot = argument;
        return 0;
    case KEY_UNITS:
        arguments->units = argument;
        return 0;
    case KEY_LATERAL:
        arguments->lateral = true;
        return 0;
    case KEY_TORSIONAL:
        arguments->torsional = true;
        return 0;
    case KEY_WEASYPRINT:
        arguments->weasyprint = argument;
        return 0;
    case KEY_EXPLORER:
        arguments->explorer = argument;
        return 0;
    case ARGP_KEY_ARG:
        return ARGP_ERR_UNKNOWN; // ARGP_KEY_ARGS reads all paths together
    // Take the results, and the folder of the report.
    case ARGP_KEY_ARGS:
        arguments->results = state->argv + state->next;
        arguments->count = (size_t)(state->argc - state->next);
        return 0;
    case ARGP_KEY_NO_ARGS:
        require_option(state, NULL, "RESULT.h5");
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->directory, "-o DIR");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/// Reads a result. The name of its file becomes that of its folder in the report, and must be unique.
static int read_entry(const char *path, entry *entries, size_t index) {
    entry *const mine = &entries[index];
    base_name(path, ".h5", mine->name, sizeof mine->name);
    for (size_t i = 0; i < index; i++)
        if (strcmp(entries[i].name, mine->name) == 0) {
            complain("two results are called '%s': their folders in the report would be one; rename one of them",
                     mine->name);
            return EXIT_BAD_INPUT;
        }
    return load_result(path, &mine->result);
}

static int read_claims(const char *path, whirl_claims **claims) {
    whirl_problems problems = {0};
    const whirl_status status = whirl_claims_load(path, &problems, claims);
    return status.code == WHIRL_OK ? EXIT_DONE : complain_of_problems(&problems, &status);
}

/// Finds the explorer's template, built or installed, relative to the program. Returns its path, or NULL if there is
/// none.
static const char *find_template(char path[PATH_SIZE]) {
    static const char *const places[] = {"explorer/template.html", "../share/whirl/explorer.html"};
    char program[PATH_SIZE / 2];
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program);
    if (length <= 0 || (size_t)length >= sizeof program) return NULL;
    program[length] = '\0';
    char *slash = strrchr(program, '/');
    if (!slash) return NULL;
    slash[1] = '\0';
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        snprintf(path, PATH_SIZE, "%s%s", program, places[i]);
        if (access(path, R_OK) == 0) return path;
    }
    return NULL;
}

/// Prints the path of the explorer, or reports that it was not built.
static void print_explorer(const report_arguments *arguments, bool built) {
    if (!built)
        complain("explorer.html is left out: its template is not built; `make explorer` builds it");
    else
        printf("%s/explorer.html\n", arguments->directory);
}

static int write_report(const report_arguments *arguments, const entry *entries, const whirl_claims *claims) {
    const whirl_result **const results = calloc(arguments->count, sizeof *results);
    const char **const names = calloc(arguments->count, sizeof *names);
    char template[PATH_SIZE], found[PATH_SIZE];
    const char *explorer = arguments->explorer ? arguments->explorer : find_template(template);
    bool kept = false;
    whirl_status status = whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
    // Write the report; without --force no existing file may be replaced.
    if (results && names) {
        for (size_t i = 0; i < arguments->count; i++) {
            results[i] = entries[i].result;
            names[i] = entries[i].name;
        }
        const whirl_report_options how = {.claims = claims,
                                          .gnuplot = arguments->gnuplot,
                                          .explorer = explorer,
                                          .units = arguments->units,
                                          .lateral = arguments->lateral,
                                          .torsional = arguments->torsional,
                                          .weasyprint = arguments->weasyprint};
        kept = !arguments->force &&
               whirl_report_find(names, arguments->count, arguments->directory, &how, found, sizeof found);
        if (kept) complain("'%s' is there already and is kept: add --force to replace it", found);
        status = kept ? whirl_ok() : whirl_report_write(results, names, arguments->count, arguments->directory, &how);
    }
    free(results);
    free(names);
    if (kept) return EXIT_FAILED;
    // Print the paths of the pages.
    if (status.code == WHIRL_OK && !arguments->quiet) {
        printf("%s/report.html\n", arguments->directory);
        print_explorer(arguments, explorer != NULL);
        const char *const documents[] = {arguments->lateral ? "lateral" : NULL,
                                         arguments->torsional ? "torsional" : NULL};
        for (size_t i = 0; i < 2; i++)
            if (documents[i])
                printf("%s/%s.html\n%s/%s.pdf\n", arguments->directory, documents[i], arguments->directory,
                       documents[i]);
    }
    return complain_of(&status);
}

static int report_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = report_parse,
        .args_doc = "RESULT.h5... -o DIR",
        .doc = "Draws the figures of results with gnuplot and writes two pages: DIR/report.html shows all of them, and "
               "DIR/explorer.html also computes in a browser. Scripts and data are kept in the folder of the figures.",
    };
    report_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    // Read all results and the claims.
    if (!output_may_be_folder(arguments.directory)) return EXIT_FAILED;
    whirl_claims *claims = NULL;
    entry *const entries = calloc(arguments.count, sizeof *entries);
    int outcome = EXIT_DONE;
    if (!entries) {
        complain("%s", whirl_code_text(WHIRL_NO_MEMORY));
        outcome = EXIT_FAILED;
    }
    for (size_t i = 0; outcome == EXIT_DONE && i < arguments.count; i++)
        outcome = read_entry(arguments.results[i], entries, i);
    for (size_t i = 0; outcome == EXIT_DONE && i < arguments.count; i++) keep_private(arguments.results[i]);
    if (arguments.claims) keep_private(arguments.claims);
    if (outcome == EXIT_DONE && arguments.claims) outcome = read_claims(arguments.claims, &claims);
    // Write the report.
    if (outcome == EXIT_DONE) outcome = write_report(&arguments, entries, claims);
    for (size_t i = 0; entries && i < arguments.count; i++) whirl_result_free(entries[i].result);
    free(entries);
    whirl_claims_free(claims);
    return outcome;
}

const command report_command = {"report", "draw figures and write a page from results", report_run};
