/// Problems of a file: reporting and sorting them.
#ifndef CASE_PROBLEM_H
#define CASE_PROBLEM_H

#include "tree.h"
#include "whirl/engine/case.h"

#include <stdbool.h>

enum { SHOWN_SIZE = 64 };

#if defined(__GNUC__)
#define PROBLEM_FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define PROBLEM_FORMAT(n)
#endif

/// Reports a problem at a place without a key; line 0: the file as a whole.
void problem_in_file(whirl_problems *problems, int line, int column, const char *format, ...) PROBLEM_FORMAT(4);

/// Reports a problem of a value: at the value's place if it is a word, else at its key.
void problem_at(whirl_problems *problems, const file_node *where, const char *format, ...) PROBLEM_FORMAT(3);

/// Reports a problem at the key of a mapping's member.
void problem_at_key(whirl_problems *problems, const file_node *where, const char *format, ...) PROBLEM_FORMAT(3);

/// Reports that a mapping lacks `key`.
void problem_missing(whirl_problems *problems, const file_node *mapping, const char *key, const char *format, ...)
    PROBLEM_FORMAT(4);

/// Message for a value that could not be read for lack of memory, so that the file is not blamed.
extern const char problem_no_memory[];

/// Returns true if that message was reported, or there was no memory to report anything.
bool problems_blame_memory(const whirl_problems *problems);

/// Sorts problems by line, then column.
void problems_sort(whirl_problems *problems);

/// Describes a value in a message: the text (shortened), "a list", "a mapping", "nothing".
const char *node_shown(const file_node *node, char text[SHOWN_SIZE]);

/// Shortens a text for a message, without line breaks.
const char *text_shown(const char *text, char shown[SHOWN_SIZE]);

#endif
