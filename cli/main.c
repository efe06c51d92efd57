/// whirl COMMAND ...: finds the command and calls its function.
#include "command.h"
#include "guard.h"
#include "ranks.h"
#include "together.h"

#include <stdio.h>
#include <string.h>

static const command help_command;

static const command *const commands[] = {&new_command,     &import_command,  &run_command,      &merge_command,
                                          &verify_command,  &check_command,   &describe_command, &report_command,
                                          &figure_command,  &table_command,   &show_command,     &export_command,
                                          &balance_command, &bearing_command, &help_command};
enum { COMMAND_COUNT = sizeof commands / sizeof *commands };

/// The chosen command (the first argument), and the index of its own arguments.
typedef struct choice {
    const char *name;
    int index;
} choice;

static void print_version(FILE *stream, struct argp_state *state) {
    const char *const revision = whirl_revision();
    (void)state;
    if (strcmp(revision, "unknown") == 0)
        fprintf(stream, "whirl %s\n", WHIRL_VERSION);
    else
        fprintf(stream, "whirl %s (commit %s)\n", WHIRL_VERSION, revision);
}

/// Lists the commands for argp's help text.
static void list_commands(struct argp_option options[COMMAND_COUNT + 2]) {
    *options++ = (struct argp_option){.doc = "Commands:", .group = 1};
    for (int i = 0; i < COMMAND_COUNT; i++)
        *options++ = (struct argp_option){
            .name = commands[i]->name, .flags = OPTION_DOC, .doc = commands[i]->meaning, .group = 1};
    *options = (struct argp_option){0};
}

static error_t main_parse(int key, char *argument, struct argp_state *state) {
    choice *chosen = state->input;
    switch (key) {
    case ARGP_KEY_ARG:
        chosen->name = argument;
        chosen->index = state->next - 1;
        state->next = state->argc; // the command reads the other arguments
        return 0;
    case ARGP_KEY_NO_ARGS:
        bad_argument(state, "a command is missing; 'whirl --help' lists them");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/// Returns whirl's command for a name that is common in other programs, or NULL.
static const char *usual_name(const char *name) {
    static const char *const names[][2] = {
        {"plot", "report"}, {"draw", "report"}, {"graph", "report"},   {"solve", "run"},      {"simulate", "run"},
        {"compute", "run"}, {"lint", "check"},  {"validate", "check"}, {"convert", "import"}, {"print", "show"},
        {"list", "show"},   {"init", "new"},    {"create", "new"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i][0]) == 0) return names[i][1];
    return NULL;
}

static const command *find_command(const char *name) {
    const char *names[COMMAND_COUNT];
    for (int i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(name, commands[i]->name) == 0) return commands[i];
        names[i] = commands[i]->name;
    }
    const char *nearest = usual_name(name);
    if (!nearest) nearest = whirl_nearest_name(name, names, COMMAND_COUNT);
    if (nearest)
        complain("there is no command '%s', did you mean '%s'?", name, nearest);
    else
        complain("there is no command '%s'; 'whirl --help' lists them", name);
    return NULL;
}

/// Returns the argp parser of `whirl` without a command; the caller owns the options.
static struct argp whirl_argp(struct argp_option options[COMMAND_COUNT + 2]) {
    list_commands(options);
    return (struct argp){
        .options = options,
        .parser = main_parse,
        .args_doc = "COMMAND [ARGUMENT...]",
        .doc = "Nonlinear dynamics of rotating machines: from a case file to a report.\v"
               "'whirl COMMAND --help' or 'whirl help COMMAND' shows what a command takes; 'man whirl' has it all.\n"
               "Exit status: 0 done, 1 failed while running, 2 bad input, 3 stopped before the end: --resume goes on.",
    };
}

static int run_command_by_name(const command *found, int argc, char **argv) {
    char title[32]; // argp and getopt name the program by this
    snprintf(title, sizeof title, "whirl %s", found->name);
    argv[0] = title;
    return found->run(argc, argv);
}

// ---------------------------------------------------------------- whirl help

static error_t parse_help(int key, char *argument, struct argp_state *state) {
    const char **name = state->input;
    if (key != ARGP_KEY_ARG) return ARGP_ERR_UNKNOWN;
    if (*name) bad_argument(state, "takes one command, '%s' is one too many", argument);
    *name = argument;
    return 0;
}

static int help(int argc, char **argv) {
    static const struct argp argp = {
        .parser = parse_help,
        .args_doc = "[COMMAND]",
        .doc = "Lists the commands, or shows the options of one, as 'whirl COMMAND --help' does.",
    };
    const char *name = NULL;
    const int read = read_arguments(&argp, argc, argv, 0, &name);
    if (read != EXIT_DONE) return read;
    const command *const found = name ? find_command(name) : NULL;
    if (name && !found) return EXIT_BAD_INPUT;
    char program[] = "whirl", option[] = "--help";
    char *arguments[] = {program, option, NULL};
    if (found) return run_command_by_name(found, 2, arguments);
    struct argp_option options[COMMAND_COUNT + 2];
    const struct argp whole = whirl_argp(options);
    argp_help(&whole, stdout, ARGP_HELP_STD_HELP, program);
    return finish_output();
}

static const command help_command = {"help", "list the commands, or show the options of one", help};

static int whirl(int argc, char **argv) {
    argp_err_exit_status = EXIT_BAD_INPUT;
    argp_program_version_hook = print_version;
    choice chosen = {0};
    struct argp_option options[COMMAND_COUNT + 2];
    const struct argp argp = whirl_argp(options);
    const int read = read_arguments(&argp, argc, argv, ARGP_IN_ORDER, &chosen);
    if (read != EXIT_DONE) return read;
    const command *const found = find_command(chosen.name);
    if (!found) return EXIT_BAD_INPUT;
    if (found != &run_command) ranks_dismiss();
    return ranks_number() < ranks_count() ? run_command_by_name(found, argc - chosen.index, argv + chosen.index)
                                          : EXIT_DONE;
}

int main(int argc, char **argv) {
    ranks_begin(&argc, &argv);
    guard_leave(ranks_end(whirl(argc, argv), together_look));
}
