/// whirl import: makes a case of a rotor that another program has saved.
#include "command.h"

#include <stdbool.h>
#include <stdio.h>

#include "files.h"
#include "output.h"
#include "whirl/internal/import.h"

typedef struct import_arguments {
    const char *rotor, *output;
    bool force;
} import_arguments;

enum { KEY_FORCE = 256 };

static const struct argp_option options[] = {
    {"output", 'o', "CASE.yaml", 0, "Write the case here (default: standard output)", 0},
    {"force", KEY_FORCE, NULL, 0, "Replace an existing file", 0},
    {0}};

static error_t import_parse(int key, char *argument, struct argp_state *state) {
    import_arguments *arguments = state->input;
    switch (key) {
    case 'o':
        arguments->output = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->rotor) bad_argument(state, "takes one rotor, '%s' is one too many", argument);
        arguments->rotor = argument;
        return 0;
    case ARGP_KEY_END:
        require_option(state, arguments->rotor, "ROTOR.toml");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int import(const import_arguments *arguments) {
    whirl_imported imported;
    const whirl_status status = whirl_import_load(arguments->rotor, &imported);
    if (status.code != WHIRL_OK) return complain_of(&status);
    int done = EXIT_DONE;
    if (arguments->output) {
        keep_private(arguments->rotor);
        done = write_whole(arguments->output, arguments->force, imported.text);
    } else {
        fputs(imported.text, stdout);
        done = finish_output();
    }
    for (size_t i = 0; i < imported.note_count && done == EXIT_DONE; i++)
        complain_as(arguments->rotor, "%s", imported.notes[i]);
    whirl_imported_free(&imported);
    return done;
}

static int import_run(int argc, char **argv) {
    static const struct argp argp = {
        .options = options,
        .parser = import_parse,
        .args_doc = "ROTOR.toml",
        .doc = "Makes a case of a rotor that ROSS has saved (Rotor.save, TOML or JSON): shafts and the couplings "
               "between them, discs, bearings and seals with their tables, magnetic bearings, point masses and "
               "supports. Reports omissions and differences from ROSS on standard error and in the case's comments. "
               "Parts that would change the motion and cannot be converted are errors: gears, torque. whirl import "
               "rotor.toml -o rotor.yaml && whirl run rotor.yaml.",
    };
    import_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    return read == EXIT_DONE ? import(&arguments) : read;
}

const command import_command = {"import", "make a case of a rotor saved by another program", import_run};
