/// Writes text in HTML. All text from a case, a result or a claim is written by these functions.
#ifndef REPORT_HTML_H
#define REPORT_HTML_H

#include "whirl/internal/shown.h"

#include <stdio.h>

/// Writes any text as element content or an attribute in double quotes: escapes markup and quotes, and replaces control
/// characters and bytes that are not UTF-8 by U+FFFD.
void html_text(FILE *stream, const char *text);

/// Formats as printf and writes the text by html_text; texts are cut at 4095 bytes.
void html_printf(FILE *stream, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// Begins a table of a class ("" for none) in a region that scrolls if the table is wider than the page. The region has
/// a label and can be reached by keyboard. End the table with </table></div>.
void html_table(FILE *stream, const char *label, const char *class);

#endif
