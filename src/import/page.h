/// Writing a case: quantities, comments, and mappings in braces that are broken into lines.
#ifndef IMPORT_PAGE_H
#define IMPORT_PAGE_H

#include <stdio.h>

enum { PAGE_WIDTH = 120, QUANTITY_SIZE = 64 };

/// A line that is being written, broken between its items.
typedef struct page_line {
    FILE *out;
    int column, indent; ///< current column; indent of the next line
    int items;          ///< since page_open
} page_line;

/// Writes a number and its unit. The number has at most 15 significant digits, so that 0.1 is not written
/// 0.10000000000000001, and a decimal point in every locale.
void page_quantity(double number, const char *unit, char text[QUANTITY_SIZE]);

/// Starts a line with `head`; later lines are indented by `indent`.
page_line page_open(FILE *out, int indent, const char *head);

/// Adds an item, after a comma unless it is the first. The format is that of printf.
void page_item(page_line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Adds "key: number unit".
void page_number(page_line *line, const char *key, double number, const char *unit);

/// Ends the line with `tail`, and with a comment (cut at the end of the line) unless NULL.
void page_close(page_line *line, const char *tail, const char *comment);

/// Writes a text as a comment, broken into lines, each after `mark` ("# "); later lines are indented by the width of
/// `hang`.
void page_comment(FILE *out, const char *mark, const char *hang, const char *text);

#endif
