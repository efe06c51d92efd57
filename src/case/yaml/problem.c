#include "problem.h"
#include "tree.h"
#include "utf8.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_PROBLEMS = 100 };

const char problem_no_memory[] = "cannot be read, for there is no memory";

bool problems_blame_memory(const whirl_problems *problems) {
    if (problems->count > 0 && !problems->items) return true;
    for (size_t i = 0; i < problems->count; i++)
        if (strstr(problems->items[i].message, problem_no_memory)) return true;
    return false;
}

/// Adds an empty problem; NULL without memory or beyond MAX_PROBLEMS. Without memory the problem is still counted, so
/// that the case is not accepted.
static whirl_problem *add_problem(whirl_problems *problems) {
    if (!problems->items) {
        problems->items = calloc(MAX_PROBLEMS, sizeof *problems->items);
        problems->capacity = problems->items ? MAX_PROBLEMS : 0;
    }
    if (!problems->items) {
        problems->count = 1;
        return NULL;
    }
    return problems->count < problems->capacity ? &problems->items[problems->count++] : NULL;
}

static void place(whirl_problem *problem, const file_node *where, bool at_key) {
    const bool word = where->kind == NODE_TEXT && !node_is_null(where);
    const bool use_key = where->key && where->key_line > 0 && (at_key || !word);
    problem->line = use_key ? where->key_line : where->line;
    problem->column = use_key ? where->key_column : where->column;
    node_path(where, problem->key, sizeof problem->key);
}

/// Writes the message; one that is too long ends with a whole word and "...".
static void write_message(whirl_problem *problem, const char *format, va_list arguments) {
    const size_t size = sizeof problem->message, room = size - sizeof "...";
    const int length = vsnprintf(problem->message, size, format, arguments);
    if (length < 0 || (size_t)length < size) return;
    size_t end = room;
    while (end > 0 && problem->message[end - 1] != ' ') end--;
    snprintf(problem->message + end, size - end, "...");
}

void problem_in_file(whirl_problems *problems, int line, int column, const char *format, ...) {
    whirl_problem *problem = add_problem(problems);
    if (!problem) return;
    problem->line = line;
    problem->column = column;
    va_list arguments;
    va_start(arguments, format);
    write_message(problem, format, arguments);
    va_end(arguments);
}

void problem_at(whirl_problems *problems, const file_node *where, const char *format, ...) {
    whirl_problem *problem = add_problem(problems);
    if (!problem) return;
    place(problem, where, false);
    va_list arguments;
    va_start(arguments, format);
    write_message(problem, format, arguments);
    va_end(arguments);
}

void problem_at_key(whirl_problems *problems, const file_node *where, const char *format, ...) {
    whirl_problem *problem = add_problem(problems);
    if (!problem) return;
    place(problem, where, true);
    va_list arguments;
    va_start(arguments, format);
    write_message(problem, format, arguments);
    va_end(arguments);
}

void problem_missing(whirl_problems *problems, const file_node *mapping, const char *key, const char *format, ...) {
    whirl_problem *problem = add_problem(problems);
    if (!problem) return;
    place(problem, mapping, true);
    const size_t used = strlen(problem->key);
    snprintf(problem->key + used, sizeof problem->key - used, "%s%s", used ? "." : "", key);
    va_list arguments;
    va_start(arguments, format);
    write_message(problem, format, arguments);
    va_end(arguments);
}

static bool stands_before(const whirl_problem *a, const whirl_problem *b) {
    return a->line != b->line ? a->line < b->line : a->column < b->column;
}

void problems_sort(whirl_problems *problems) {
    if (!problems->items) return;
    for (size_t i = 1; i < problems->count; i++) {
        const whirl_problem moved = problems->items[i];
        size_t k = i;
        for (; k > 0 && stands_before(&moved, &problems->items[k - 1]); k--)
            problems->items[k] = problems->items[k - 1];
        problems->items[k] = moved;
    }
}

const char *text_shown(const char *text, char shown[SHOWN_SIZE]) {
    const size_t room = SHOWN_SIZE - 4;
    size_t length = strlen(text);
    const bool cut = length > room;
    if (cut) length = utf8_cut(text, room);
    for (size_t i = 0; i < length; i++) shown[i] = text[i] == '\n' || text[i] == '\t' ? ' ' : text[i];
    strcpy(shown + length, cut ? "..." : "");
    return shown;
}

const char *node_shown(const file_node *node, char text[SHOWN_SIZE]) {
    if (node->kind == NODE_LIST) return "a list";
    if (node->kind == NODE_MAPPING) return "a mapping";
    return node->text[0] == '\0' ? "empty" : text_shown(node->text, text);
}

void whirl_problem_text(const whirl_problems *problems, size_t index, char *text, size_t size) {
    if (!problems->items || index >= problems->count) {
        snprintf(text, size, "%s", problems->items ? "" : "no memory to say what is wrong");
        return;
    }
    const whirl_problem *problem = &problems->items[index];
    char place[64] = "";
    if (problem->line > 0) snprintf(place, sizeof place, "%d:%d:", problem->line, problem->column);
    const char *colon = problems->file[0] ? ":" : "";
    const char *space = problems->file[0] || place[0] ? " " : "";
    snprintf(text, size, "%s%s%s%s%s%s%s", problems->file, colon, place, space, problem->key,
             problem->key[0] ? ": " : "", problem->message);
}

void whirl_problems_text(const whirl_problems *problems, char *text, size_t size) {
    size_t used = 0;
    if (size > 0) text[0] = '\0';
    for (size_t i = 0; i < problems->count && used + 1 < size; i++) {
        char line[512];
        whirl_problem_text(problems, i, line, sizeof line);
        const int length = snprintf(text + used, size - used, "%s%s", i > 0 ? "\n" : "", line);
        used += length > 0 ? (size_t)length : 0;
    }
}

void whirl_problems_free(whirl_problems *problems) {
    free(problems->items);
    *problems = (whirl_problems){0};
}
