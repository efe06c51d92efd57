#include "source.h"
#include "problem.h"
#include "tree.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input.h"
#include "utf8.h"
#include "whirl/status.h"

whirl_status source_load(const char *path, whirl_problems *problems, char **text, size_t *length) {
    input_file in;
    if (problems) snprintf(problems->file, sizeof problems->file, "%s", path);
    if (input_read(path, TREE_MAX_BYTES + 4, &in, text, length)) return whirl_ok();
    if (in.no_memory) return whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.240s", path);
    return whirl_fail(WHIRL_BAD_INPUT, "%.240s cannot be read: %s", path, in.reason);
}

/// Reports a byte that is not UTF-8, and a character that controls a terminal or reverses the direction of text.
/// Returns true if there was one.
static bool report_character(const char *text, size_t bytes, int line, int column, whirl_problems *problems) {
    const unsigned char c = (unsigned char)text[0];
    if (bytes == 0)
        problem_in_file(problems, line, column, "has the byte 0x%02X, expected text in UTF-8", c);
    else if (c == '\t' || c == '\n' || c == '\r' || utf8_is_plain(text, bytes))
        return false;
    else if (bytes == 1)
        problem_in_file(problems, line, column,
                        "has the byte 0x%02X, expected text in UTF-8 without control characters", c);
    else
        problem_in_file(
            problems, line, column, "has the character U+%04X, expected text without %s", utf8_character(text, bytes),
            bytes == 2 && c == 0xC2 ? "control characters" : "characters that end a line or turn its direction");
    return true;
}

/// Returns true for a line with content; blank lines and comments may begin with tabs.
static bool line_says_something(const char *text, size_t length) {
    size_t i = 0;
    while (i < length && (text[i] == ' ' || text[i] == '\t')) i++;
    return i < length && text[i] != '\n' && text[i] != '\r' && text[i] != '#';
}

void source_check(const char *text, size_t length, whirl_problems *problems) {
    if (length > TREE_MAX_BYTES) {
        problem_in_file(problems, 0, 0, "is larger than 1 MiB, expected a case of at most %d bytes", TREE_MAX_BYTES);
        return;
    }
    int line = 1, column = 1;
    bool indenting = true;
    for (size_t i = 0; i < length;) {
        const unsigned char c = (unsigned char)text[i];
        const size_t bytes = utf8_length(text + i, length - i);
        if (report_character(text + i, bytes, line, column, problems)) return;
        if (indenting && c == '\t' && line_says_something(text + i, length - i)) {
            problem_in_file(problems, line, column, "is indented with a tab, expected spaces");
            indenting = false;
        }
        if (c != ' ' && c != '\t') indenting = c == '\n';
        column = c == '\n' ? 1 : column + 1;
        line += c == '\n';
        i += bytes;
    }
}
