#include "command.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 8192 }; // a path may have 4096 bytes

/// One line on standard error. Names of files, and what stands in them, are not to steer the terminal.
static void say(const char *program, const char *format, va_list arguments) {
    char line[LONGEST_LINE];
    vsnprintf(line, sizeof line, format, arguments);
    whirl_make_plain(line);
    fprintf(stderr, "%s: %s\n", program, line);
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

int complain_of_problems(whirl_problems *problems, const whirl_status *status) {
    for (size_t i = 0; i < problems->count; i++) {
        char text[sizeof problems->file + sizeof(whirl_problem)];
        whirl_problem_text(problems, i, text, sizeof text);
        whirl_make_plain(text);
        fprintf(stderr, "%s\n", text);
    }
    if (problems->count > 0)
        complain("%zu problem%s in %s", problems->count, problems->count == 1 ? "" : "s", problems->file);
    else
        complain_of(status);
    whirl_problems_free(problems);
    return EXIT_BAD_INPUT;
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
