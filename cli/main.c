/// whirl COMMAND ...: finds the command and hands over.
#include "command.h"

#include <stdio.h>
#include <string.h>

static const command *const commands[] = {&run_command,      &verify_command, &check_command,
                                          &describe_command, &report_command, &export_command};
enum { COMMAND_COUNT = sizeof commands / sizeof *commands };

/// What the first argument chose, and where its own arguments begin.
typedef struct choice {
    const char *name;
    int index;
} choice;

static void print_version(FILE *stream, struct argp_state *state) {
    (void)state;
    fprintf(stream, "whirl %s\n", WHIRL_VERSION);
}

/// The table of commands as argp shows it in the help text, beside the options.
static void list_commands(struct argp_option options[COMMAND_COUNT + 2]) {
    *options++ = (struct argp_option){.doc = "Commands:", .group = 1};
    for (int i = 0; i < COMMAND_COUNT; i++)
        *options++ = (struct argp_option){
            .name = commands[i]->name, .flags = OPTION_DOC, .doc = commands[i]->meaning, .group = 1};
    *options = (struct argp_option){0};
}

static error_t parse(int key, char *argument, struct argp_state *state) {
    choice *chosen = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        chosen->name = argument;
        chosen->index = state->next - 1;
        state->next = state->argc; // the rest belongs to the command
        return 0;
    case ARGP_KEY_NO_ARGS:
        bad_argument(state, "a command is missing; 'whirl --help' lists them");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const command *find_command(const char *name) {
    const char *names[COMMAND_COUNT];
    for (int i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(name, commands[i]->name) == 0) return commands[i];
        names[i] = commands[i]->name;
    }
    const char *nearest = whirl_nearest_name(name, names, COMMAND_COUNT);
    if (nearest)
        complain("there is no command '%s', did you mean '%s'?", name, nearest);
    else
        complain("there is no command '%s'; 'whirl --help' lists them", name);
    return NULL;
}

/// `whirl help` and `whirl help COMMAND` are the option --help.
static void read_help(int *argc, char **argv) {
    static char help[] = "--help";
    if (*argc < 2 || strcmp(argv[1], "help") != 0) return;
    if (*argc > 2) argv[1] = argv[2];
    argv[*argc > 2 ? 2 : 1] = help;
    *argc = *argc > 2 ? 3 : 2;
}

int main(int argc, char **argv) {
    read_help(&argc, argv);
    struct argp_option options[COMMAND_COUNT + 2];
    list_commands(options);
    const struct argp argp = {
        .options = options,
        .parser = parse,
        .args_doc = "COMMAND [ARGUMENT...]",
        .doc = "Nonlinear dynamics of rotating machines: from a case file to a report.\v"
               "'whirl COMMAND --help' or 'whirl help COMMAND' shows what a command takes; 'man whirl' has it all.\n"
               "Exit status: 0 done, 1 failed while running, 2 bad input.",
    };
    argp_err_exit_status = EXIT_BAD_INPUT;
    argp_program_version_hook = print_version;
    choice chosen = {0};
    if (argp_parse(&argp, argc, argv, ARGP_IN_ORDER, NULL, &chosen) != 0) return EXIT_FAILED;
    const command *const found = find_command(chosen.name);
    if (!found) return EXIT_BAD_INPUT;

    char title[32]; // argp and getopt name the program by this
    snprintf(title, sizeof title, "whirl %s", found->name);
    argv[chosen.index] = title;
    return found->run(argc - chosen.index, argv + chosen.index);
}
