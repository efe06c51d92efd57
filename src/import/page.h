/// Writing a case: quantities, comments, and mappings in braces that are broken into lines.
#ifndef IMPORT_PAGE_H
#define IMPORT_PAGE_H

#include <stdio.h>

enum { PAGE_WIDTH = 120, QUANTITY_SIZE = 64 };

/// A line that is being written, broken between its items.
typedef struct page_line {
    FILE *out;
    int column, indent; ///< of what is written, and where its next line begins
    int items;          ///< since page_open
} page_line;

/// A number with at most 15 significant digits and a decimal point in every locale, so that 0.1 is no
/// 0.10000000000000001, and its unit.
void page_quantity(double number, const char *unit, char text[QUANTITY_SIZE]);

/// Starts a line with `head`; what follows is broken to `indent`.
page_line page_open(FILE *out, int indent, const char *head);

/// Adds an item, behind a comma where one stands before it; printf.
void page_item(page_line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));

/// Ends the line with `tail`, and with a comment (cut at the end of the line) where it is not NULL.
void page_close(page_line *line, const char *tail, const char *comment);

/// A text as a comment, broken into lines, each behind `mark` ("# "); later lines are indented by the blanks of `hang`.
void page_comment(FILE *out, const char *mark, const char *hang, const char *text);

#endif
