/// What the terminal can show, if there is one.
#ifndef CLI_TERMINAL_H
#define CLI_TERMINAL_H

#include <stdbool.h>

/// Whether a file descriptor is a terminal.
bool is_terminal(int descriptor);

/// Whether colours may be written to it: a terminal that is not dumb, where NO_COLOR (no-color.org) is absent or empty.
bool has_colours(int descriptor);

/// Columns of the terminal behind a file descriptor, from 40 on; where there is none, those that COLUMNS says, else 80.
int terminal_columns(int descriptor);

/// Columns that a text takes: continuation bytes of UTF-8 take none.
int text_columns(const char *text);

/// Prints words to standard output, broken so that no line is longer than `width` where that is possible. The first
/// line goes on at column `at`, the others begin at `indent`. No newline at the end.
void print_wrapped(const char *text, int at, int indent, int width);

#endif
