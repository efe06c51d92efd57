/// whirl new: writes a case to start from.
#include "command.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "files.h"
#include "starters.h"

typedef struct new_arguments {
    const char *kind, *output;
    bool force;
} new_arguments;

enum { KEY_FORCE = 256, MAX_STARTERS = 8, OPTION_COUNT = 2 };

static error_t new_parse(int key, char *argument, struct argp_state *state) {
    new_arguments *arguments = state->input;
    switch (key) {
    case 'o':
        arguments->output = argument;
        return 0;
    case KEY_FORCE:
        arguments->force = true;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->kind) bad_argument(state, "takes one kind of case, '%s' is one too many", argument);
        arguments->kind = argument;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/// Lists the options, and the kinds of cases for argp's help text.
static void list_options(struct argp_option options[OPTION_COUNT + MAX_STARTERS + 2]) {
    *options++ = (struct argp_option){
        .name = "output", .key = 'o', .arg = "CASE.yaml", .doc = "Write the case here (default: standard output)"};
    *options++ = (struct argp_option){.name = "force", .key = KEY_FORCE, .doc = "Replace an existing file"};
    *options++ = (struct argp_option){.doc = "Kinds:", .group = 1};
    for (size_t i = 0; i < MAX_STARTERS && starter_at(i); i++)
        *options++ = (struct argp_option){
            .name = starter_at(i)->name, .flags = OPTION_DOC, .doc = starter_at(i)->meaning, .group = 1};
    *options = (struct argp_option){0};
}

static const starter *find_starter(const char *kind) {
    const char *names[MAX_STARTERS];
    size_t count = 0;
    for (; count < MAX_STARTERS && starter_at(count); count++) {
        if (strcmp(starter_at(count)->name, kind) == 0) return starter_at(count);
        names[count] = starter_at(count)->name;
    }
    const char *nearest = whirl_nearest_name(kind, names, count);
    if (nearest)
        complain("there is no case '%s' to start from, did you mean '%s'?", kind, nearest);
    else
        complain("there is no case '%s' to start from; 'whirl new --help' lists them", kind);
    return NULL;
}

static int new_run(int argc, char **argv) {
    struct argp_option options[OPTION_COUNT + MAX_STARTERS + 2];
    const struct argp argp = {
        .options = options,
        .parser = new_parse,
        .args_doc = "[KIND]",
        .doc = "Writes a commented case to start from, ready to run: whirl new -o rotor.yaml && whirl run rotor.yaml.",
    };
    list_options(options);
    new_arguments arguments = {0};
    const int read = read_arguments(&argp, argc, argv, 0, &arguments);
    if (read != EXIT_DONE) return read;
    const starter *const chosen = arguments.kind ? find_starter(arguments.kind) : starter_at(0);
    if (!chosen) return EXIT_BAD_INPUT;
    if (arguments.output) return write_whole(arguments.output, arguments.force, chosen->text);
    fputs(chosen->text, stdout);
    return finish_output();
}

const command new_command = {"new", "write a case to start from", new_run};
