#include "command.h"
#include "guard.h"
#include "terminal.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/// Escape sequences for a terminal with colours; empty elsewhere.
typedef struct colours {
    const char *bold, *error, *mark, *plain;
} colours;

static colours find_colours(void) {
    if (!has_colours(STDERR_FILENO)) return (colours){"", "", "", ""};
    return (colours){"\033[1m", "\033[1;31m", "\033[1;32m", "\033[0m"};
}

enum { LONGEST_LINE = 8192 }; // a path may have 4096 bytes

/// Writes one line to standard error, without control characters: names and contents of files must not control the
/// terminal.
static void say(const char *program, const char *format, va_list arguments) {
    char line[LONGEST_LINE];
    const colours c = find_colours();
    vsnprintf(line, sizeof line, format, arguments);
    whirl_make_plain(line);
    fprintf(stderr, "%s%s:%s %s\n", c.error, program, c.plain, line);
}

void complain(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    say("whirl", format, arguments);
    va_end(arguments);
}

void complain_as(const char *program, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    say(program, format, arguments);
    va_end(arguments);
}

int complain_of(const whirl_status *status) {
    if (status->code == WHIRL_OK) return EXIT_DONE;
    complain("%s", status->message[0] ? status->message : whirl_code_text(status->code));
    if (status->code == WHIRL_NO_MEMORY) guard_note_exhausted();
    return status->code == WHIRL_BAD_INPUT ? EXIT_BAD_INPUT : EXIT_FAILED;
}

void bad_argument(const struct argp_state *state, const char *format, ...) {
    char sentence[WHIRL_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    whirl_make_plain(sentence);
    argp_failure(state, EXIT_BAD_INPUT, 0, "%s", sentence);
}

void require_option(const struct argp_state *state, const char *value, const char *option) {
    if (!value) bad_argument(state, "%s is missing; '%s --help' shows what is expected", option, state->argv[0]);
}

/// Shows the line of the file with the problem marked, like compilers.
static void show_excerpt(const whirl_problem *problem, const colours *c) {
    if (!problem->excerpt[0]) return;
    fprintf(stderr, "%6d | %s\n       | %*s%s^", problem->line, problem->excerpt, problem->mark, "", c->mark);
    for (int i = 1; i < problem->marked; i++) fputc('~', stderr);
    fprintf(stderr, "%s\n", c->plain);
}

/// Prints a problem in one line, which programs can read. On a terminal its place is in colour, and the line of the
/// file is shown below.
static void show_problem(const whirl_problems *problems, size_t index) {
    char text[sizeof problems->file + sizeof(whirl_problem)], place[sizeof problems->file + 32] = "";
    const colours c = find_colours();
    const whirl_problem *const problem = problems->items ? &problems->items[index] : NULL;
    whirl_problem_text(problems, index, text, sizeof text);
    if (problem && problem->line > 0)
        snprintf(place, sizeof place, "%s:%d:%d:", problems->file, problem->line, problem->column);
    whirl_make_plain(text);
    whirl_make_plain(place);
    const size_t head = strncmp(text, place, strlen(place)) == 0 ? strlen(place) : 0;
    fprintf(stderr, "%s%.*s%s%s\n", c.bold, (int)head, text, c.plain, text + head);
    if (problem && is_terminal(STDERR_FILENO)) show_excerpt(problem, &c);
}

int complain_of_problems(whirl_problems *problems, const whirl_status *status) {
    const bool exhausted = status->code == WHIRL_NO_MEMORY;
    for (size_t i = 0; i < problems->count && !exhausted; i++) show_problem(problems, i);
    if (problems->count > 0 && !exhausted)
        complain("%zu problem%s in %s", problems->count, problems->count == 1 ? "" : "s", problems->file);
    else
        complain_of(status);
    whirl_problems_free(problems);
    return status->code == WHIRL_NO_MEMORY ? EXIT_FAILED : EXIT_BAD_INPUT;
}

void base_name(const char *path, const char *suffix, char *name, size_t size) {
    const char *slash = strrchr(path, '/');
    const char *start = slash ? slash + 1 : path;
    size_t length = strlen(start);
    const size_t tail = strlen(suffix);
    if (length > tail && strcmp(start + length - tail, suffix) == 0) length -= tail;
    snprintf(name, size, "%.*s", (int)length, start);
}

int finish_output(void) {
    if (fflush(stdout) == 0 && !ferror(stdout)) return EXIT_DONE;
    complain("standard output could not be written: %s", strerror(errno));
    return EXIT_FAILED;
}
