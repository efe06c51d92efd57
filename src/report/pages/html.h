// Text in HTML. Everything that comes from a case, a result or a claim goes through here.
#ifndef REPORT_HTML_H
#define REPORT_HTML_H

#include <stdio.h>

/// Writes text that may hold anything: markup and quotes escaped, control characters and bytes that are not UTF-8
/// replaced by U+FFFD. Fit for element content and for attributes in double quotes.
void html_text(FILE *stream, const char *text);

/// Formats as printf and writes the outcome by html_text; longer outcomes are cut at 4095 bytes.
void html_printf(FILE *stream, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// Begins a table of that class ("" for none) that scrolls by itself where it is wider than the page: a region with a
/// name, which the keyboard can reach. Ends with </table></div>.
void html_table(FILE *stream, const char *label, const char *class);

/// A cell of a table with a number of six digits; an empty one where it is not finite.
void html_number(FILE *stream, double value);

#endif
