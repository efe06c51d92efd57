/// Collecting what is wrong.
#ifndef CASE_PROBLEM_H
#define CASE_PROBLEM_H

#include "tree.h"
#include "whirl/engine/case.h"

enum { SHOWN_SIZE = 64 };

#if defined(__GNUC__)
#define PROBLEM_FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define PROBLEM_FORMAT(n)
#endif

/// At a place of the file without a key; line 0 stands for the file as a whole.
void problem_in_file(whirl_problems *problems, int line, int column, const char *format, ...) PROBLEM_FORMAT(4);

/// At a value: its own place when it is a word, the place of its key otherwise.
void problem_at(whirl_problems *problems, const file_node *where, const char *format, ...) PROBLEM_FORMAT(3);

/// At the key of a mapping's member.
void problem_at_key(whirl_problems *problems, const file_node *where, const char *format, ...) PROBLEM_FORMAT(3);

/// At a mapping that lacks `key`.
void problem_missing(whirl_problems *problems, const file_node *mapping, const char *key, const char *format, ...)
    PROBLEM_FORMAT(4);

/// What is said of a value that could not be read for lack of memory: then nothing is wrong with the file.
extern const char problem_no_memory[];

/// Whether that was said, or nothing could be said.
bool problems_blame_memory(const whirl_problems *problems);

/// In an order that a person can walk through: by line, then column.
void problems_sort(whirl_problems *problems);

/// What stands there in a few words for a message: the text (shortened), "a list", "a mapping", "nothing".
const char *node_shown(const file_node *node, char text[SHOWN_SIZE]);

/// A text shortened for a message, without line breaks.
const char *text_shown(const char *text, char shown[SHOWN_SIZE]);

#endif
