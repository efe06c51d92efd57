/// Properties of the terminal, if there is one.
#ifndef CLI_TERMINAL_H
#define CLI_TERMINAL_H

#include <stdbool.h>

/// Returns true if a file descriptor is a terminal.
bool is_terminal(int descriptor);

/// Returns true if colours may be written: to a terminal that is not dumb, without NO_COLOR (no-color.org).
bool has_colours(int descriptor);

/// Returns the columns of the terminal of a file descriptor, at least 40. Without a terminal it is the variable
/// COLUMNS, else 80.
int terminal_columns(int descriptor);

/// Returns the columns of a text in UTF-8: the number of its characters.
int text_columns(const char *text);

/// Prints words to standard output, in lines of at most `width` columns where possible. The first line continues at
/// column `at`, the others begin at `indent`. No newline at the end.
void print_wrapped(const char *text, int at, int indent, int width);

#endif
