#include "excerpt.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "utf8.h"

/// Characters of a long line that are shown before a place.
enum { LEAD = 60, LONGEST_MARK = 1000 };

/// Returns the bytes of the character at `at`; 1 if it is invalid.
static size_t step(const char *at, const char *end) {
    const size_t bytes = utf8_length(at, (size_t)(end - at));
    return bytes ? bytes : 1;
}

/// Appends a character, ' ' for a tab, '?' for characters that must not reach a terminal. Returns false if it does not
/// fit.
static bool append(char *to, size_t size, const char *from, size_t bytes) {
    const size_t used = strlen(to);
    const bool plain = utf8_length(from, bytes) == bytes && utf8_is_plain(from, bytes);
    if (used + bytes + 1 > size) return false;
    snprintf(to + used, size - used, "%.*s", (int)(plain ? bytes : 1), plain ? from : *from == '\t' ? " " : "?");
    return true;
}

/// Returns the length of the token at `text`: a key, a value, a quoted text; at least 1.
static size_t word_length(const char *text) {
    size_t i = 0;
    int open = 0;
    if (*text == '"' || *text == '\'') {
        const char *close = strchr(text + 1, *text);
        return close ? (size_t)(close - text) + 1 : strlen(text);
    }
    for (; text[i]; i++) {
        open += (text[i] == '(') - (text[i] == ')');
        if (strchr(open > 0 ? "}]" : ",}]", text[i])) break;
        if (text[i] == ':' && (text[i + 1] == ' ' || text[i + 1] == '\0')) break;
        if (text[i] == ' ' && text[i + 1] == '#') break;
    }
    while (i > 0 && text[i - 1] == ' ') i--;
    return i > 0 ? i : 1;
}

static int count_characters(const char *text, size_t length) {
    int count = 0;
    for (size_t i = 0; i < length && text[i] && count < LONGEST_MARK; i++)
        count += ((unsigned char)text[i] & 0xC0) != 0x80;
    return count;
}

/// Copies the line from `line` to `end`, or its part around the problem.
static void quote(whirl_problem *problem, const char *line, const char *end) {
    const int skipped = problem->column > LEAD ? problem->column - LEAD : 0;
    const char *place = NULL, *from = line;
    for (int i = 0; i < skipped && from < end; i++) from += step(from, end);
    problem->excerpt[0] = '\0';
    if (from >= end) return; // the end of the file, of a line, or of what is left of it
    if (skipped > 0) snprintf(problem->excerpt, sizeof problem->excerpt, "...");
    problem->mark = (skipped > 0 ? 3 : 0) + problem->column - 1 - skipped;
    for (int column = skipped + 1; from < end; column++) {
        const size_t bytes = step(from, end);
        const size_t used = strlen(problem->excerpt);
        if (!append(problem->excerpt, sizeof problem->excerpt, from, bytes)) break;
        if (column == problem->column) place = problem->excerpt + used;
        from += bytes;
    }
    problem->marked = place ? count_characters(place, word_length(place)) : 1;
}

void problems_quote(whirl_problems *problems, const char *text, size_t length) {
    const char *line = text, *const end = text + length;
    int number = 1;
    for (size_t i = 0; problems->items && i < problems->count; i++) {
        whirl_problem *problem = &problems->items[i];
        if (problem->line < number || problem->column < 1) continue; // no place in the file
        for (; line < end && number < problem->line; number++) {
            const char *next = memchr(line, '\n', (size_t)(end - line));
            line = next ? next + 1 : end;
        }
        const char *stop = line < end ? memchr(line, '\n', (size_t)(end - line)) : NULL;
        if (!stop) stop = end;
        if (stop > line && stop[-1] == '\r') stop--;
        quote(problem, line, stop);
    }
}
